// The permanent display: state of the connection, place, mode of movement.
import type { Stats } from '../engine/engine';
import type { Body } from '../controls/body';
import { windOf, type Place } from '../place/place';
import { count } from './traffic_panel';
import { find, say } from './dom';

/** Share of the view that is drawn or known to be empty. */
export function share(stats: Stats): number | null {
  if (stats.state === 'complete') return 1;
  return stats.chunks === 0 ? null : Math.min(0.99, Math.max(0, stats.chunks - stats.pendingMeshes) / stats.chunksWanted);
}

export class Hud {
  /** `isHere`: chunks are made by the page, not received. */
  constructor(private readonly isHere: boolean) {}

  readonly #opening = find('opening');
  readonly #toMode = find('hint').querySelector('.to-mode')!;

  opening(text: string, progress: number | null): void {
    say(find('opening-text'), text);
    const bar = find<HTMLProgressElement>('opening-progress');
    if (progress === null) bar.removeAttribute('value');
    else bar.value = progress;
  }

  /** The land is there: hides the opening screen. */
  opened(): void {
    this.#opening.classList.add('gone');
    // An indeterminate progress bar would keep running unseen.
    find<HTMLProgressElement>('opening-progress').value = 1;
    this.#opening.removeAttribute('role');
  }

  status(text: string, state: 'busy' | 'good' | 'bad'): void {
    say(find('status-text'), text);
    const pill = find('status');
    if (pill.dataset.state !== state) pill.dataset.state = state;
  }

  connection(stats: Stats): void {
    if (stats.state === 'lost') return this.status('Server away', 'bad');
    if (stats.state === 'refused') return this.status('Refused', 'bad');
    if (stats.state === 'connecting') return this.status('Connecting', 'busy');
    if (stats.state === 'complete') return this.status('All here', 'good');
    const done = share(stats);
    const what = stats.chunksWanted > 0 && stats.chunks >= stats.chunksWanted ? 'Drawing' : this.isHere ? 'Making' : 'Receiving';
    this.status(done === null ? what : `${what} ${Math.floor(done * 100)} %`, 'busy');
  }

  where(place: Place, body: Body): void {
    const [x, y, z] = [place.x, place.y ?? 0, place.z].map(Math.floor);
    // In the format for typing coordinates: without thousands separators.
    say(find('where-at'), `${x}, ${y}, ${z}`);
    const how = body.waiting
      ? 'waiting for the land'
      : body.mode === 'fly'
        ? `flying ${windOf(place.yaw)}`
        : `${body.swimming ? 'swimming' : 'walking'} ${windOf(place.yaw)}`;
    say(find('where-way'), how);
    say(find('where-speed'), body.mode === 'fly' && !body.waiting ? `, ${count(body.flySpeed)} blocks/s` : '');
    say(this.#toMode, body.mode === 'fly' ? 'walk' : 'fly');
  }
}
