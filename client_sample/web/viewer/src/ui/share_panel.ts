// Creates a picture and a link for sharing.
import type { Place } from '../place/place';
import { find, say } from './dom';

export class SharePanel {
  constructor(
    private readonly picture: () => Promise<Blob> | null,
    private readonly place: () => Place,
    writeLinkNow: () => void,
  ) {
    find('save-picture').addEventListener('click', () => void this.save());
    find('copy-link').addEventListener('click', async () => {
      writeLinkNow();
      try {
        await navigator.clipboard.writeText(location.href);
        this.#said('The link is copied.');
      } catch {
        this.#said('This browser does not let the page copy; the address above is the link.');
      }
    });
  }

  async save(): Promise<void> {
    const taking = this.picture();
    if (taking === null) return this.#said('There is no picture yet.');
    const url = URL.createObjectURL(await taking);
    const { x, z } = this.place();
    const link = document.createElement('a');
    link.href = url;
    link.download = `talus_${Math.round(x)}_${Math.round(z)}.png`;
    link.click();
    URL.revokeObjectURL(url);
    this.#said(`Saved as ${link.download}.`);
  }

  #said(text: string): void {
    say(find('share-said'), text);
  }
}
