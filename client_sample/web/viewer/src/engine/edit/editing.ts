// The player's edits: shown at once, and taken back where they are refused.
import type { Client, Edit, EditDone } from 'talus';
import type { Prediction, Predictions, VoxelChange } from './predictions.js';

export class Editing {
  /** `client()`: the one of now; null: there is none any more. */
  constructor(
    private readonly predictions: Predictions,
    private readonly client: () => Client | null,
  ) {}

  /** `changes` are what the edit does. */
  async edit(client: Client, edit: Edit, changes: readonly VoxelChange[]): Promise<EditDone> {
    const prediction = this.predictions.begin(changes);
    try {
      const done = await client.edit(edit);
      this.predictions.settled(prediction, done.revision, done.changed > 0);
      void this.resolve(prediction);
      return done;
    } catch (error) {
      this.predictions.refused(prediction);
      throw error;
    }
  }

  /** Asks for chunks that still show an edit that happened, where they do not come by themselves. */
  private async resolve(prediction: Prediction): Promise<void> {
    if (this.predictions.behind(prediction).length === 0) return;
    const client = this.client();
    if (client === null) return;
    try {
      await client.ping(); // mostly they were on their way
      for (const place of this.predictions.behind(prediction)) {
        const chunk = await client.getChunk({ lod: 0, ...place });
        if (client !== this.client()) return;
        this.predictions.resolved(prediction, place, chunk.revision, chunk);
      }
    } catch {
      if (client === this.client()) this.predictions.refused(prediction); // what came is all there is
    }
  }
}
