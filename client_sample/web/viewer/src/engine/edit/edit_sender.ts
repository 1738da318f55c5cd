// The player's edits: shown at once, and reverted if they are refused.
import type { Client, Edit, EditDone } from 'talus';
import type { Prediction, Predictions, VoxelChange } from './predictions.js';

export class EditSender {
  /** `client()`: the current client; null: there is none any more. */
  constructor(
    private readonly predictions: Predictions,
    private readonly client: () => Client | null,
  ) {}

  /** `changes`: the effect of the edit. */
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

  /** Requests chunks that still show an applied edit, unless they arrive by themselves. */
  private async resolve(prediction: Prediction): Promise<void> {
    if (this.predictions.behind(prediction).length === 0) return;
    const client = this.client();
    if (client === null) return;
    try {
      await client.ping(); // most were in flight
      for (const place of this.predictions.behind(prediction)) {
        const chunk = await client.getChunk({ lod: 0, ...place });
        if (client !== this.client()) return;
        this.predictions.resolved(prediction, place, chunk.revision, chunk);
      }
    } catch {
      if (client === this.client()) this.predictions.refused(prediction); // nothing more will arrive
    }
  }
}
