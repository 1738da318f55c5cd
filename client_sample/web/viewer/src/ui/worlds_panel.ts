// Where the page makes the world itself: other worlds, and why edits are not kept.
import type { Here } from '../here/here';
import { linkTo, MAX_TOML_BYTES, packed } from '../here/world_link';
import { find, make, say } from './dom';

const titleOf = (name: string) => name.charAt(0).toUpperCase() + name.slice(1);

export class WorldsPanel {
  constructor(here: Here, notKept: (why: string) => void) {
    here.onNotKept = notKept;
    find('open-worlds').hidden = false;
    document.body.classList.add('here');
    find('worlds-list').append(
      ...here.names.map((name) => {
        const link = make('a', titleOf(name));
        link.href = linkTo(name, location.hash);
        if (name === here.name) link.setAttribute('aria-current', 'true');
        const item = make('li');
        item.append(link);
        return item;
      }),
    );
    const file = find<HTMLInputElement>('worlds-file');
    file.addEventListener('change', () => void this.#open(file.files?.[0]));
  }

  async #open(file: File | undefined): Promise<void> {
    if (file === undefined) return;
    if (file.size > MAX_TOML_BYTES) return say(find('worlds-said'), `${file.name} has ${file.size} bytes; a world file has at most ${MAX_TOML_BYTES}.`);
    location.hash = linkTo(await packed(new Uint8Array(await file.arrayBuffer())), location.hash);
  }
}
