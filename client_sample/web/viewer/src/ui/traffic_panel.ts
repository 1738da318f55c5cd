// Data received from the server, and its use by the graphics card.
import type { Stats } from '../engine/engine';
import { find, make, say } from './dom';

const SECONDS = 60;

const WHOLE = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });

export const count = (value: number) => WHOLE.format(Math.round(value));

export function bytes(value: number): string {
  if (value < 1000) return `${Math.round(value)} B`;
  for (const unit of ['kB', 'MB', 'GB']) {
    value /= 1000;
    if (value < 1000 || unit === 'GB') return `${value < 10 ? value.toFixed(2) : value < 100 ? value.toFixed(1) : Math.round(value)} ${unit}`;
  }
  return '';
}

const ms = (value: number) => (value < 10 ? value.toFixed(1) : String(Math.round(value)));

const STATES: Record<Stats['state'], string> = {
  connecting: 'connecting',
  streaming: 'streaming',
  complete: 'complete',
  lost: 'server away',
  refused: 'refused',
};

export class TrafficPanel {
  readonly #rows = new Map<string, HTMLElement>();
  readonly #rates: number[] = [];
  #second = 0;
  #bytes = 0;
  #byteRate = 0;

  /** `isHere`: nothing is received, but made by the page. */
  constructor(private readonly isHere: boolean) {}

  /** Called four times a second, even if the panel is closed: the chart covers the last minute. */
  update(stats: Stats, now: number, framesPerSecond: number, isOpen: boolean): void {
    const second = Math.floor(now / 1000);
    if (second !== this.#second) {
      this.#second = second;
      this.#byteRate = Math.max(0, stats.receivedBytes - this.#bytes);
      this.#bytes = stats.receivedBytes;
      this.#rates.push(stats.chunkRate);
      if (this.#rates.length > SECONDS) this.#rates.shift();
    }
    if (!isOpen) return;
    const { latency, frameCpu } = stats;
    this.#row('View', STATES[stats.state]);
    this.#row('Chunks', `${count(stats.chunks)}, ${count(stats.chunkRate)} /s`);
    if (stats.madeChunks > 0) this.#row('Made here', `${count(stats.madeChunks)} chunks`);
    if (!this.isHere) this.#row('By wire', `${count(stats.receivedChunks)} chunks`);
    if (!this.isHere) this.#row('Received', `${bytes(stats.receivedBytes)}, ${bytes(this.#byteRate)}/s`);
    this.#row('Asked to drawn, p50', latency === null ? '–' : `${ms(latency.p50)} ms`);
    this.#row('p95, p99', latency === null ? '–' : `${ms(latency.p95)}, ${ms(latency.p99)} ms`);
    this.#row('Land is missing', stats.nearestMissing === null ? 'nowhere' : `${count(stats.nearestMissing)} blocks away`);
    this.#row('Meshes, to come', `${count(stats.meshes)}, ${count(stats.pendingMeshes)}`);
    this.#row('Triangles', count(stats.triangles));
    this.#row('Draw calls', count(stats.drawCalls));
    this.#row('Pictures a second', framesPerSecond.toFixed(0));
    this.#row('Frame, p50, p95', `${ms(frameCpu.p50)}, ${ms(frameCpu.p95)} ms`);
    this.#row('On the card, in the page', `${bytes(stats.gpuBytes)}, ${bytes(stats.heapBytes)}`);
    this.#chart();
    this.#levels(stats.chunksPerLevel);
  }

  #row(name: string, value: string): void {
    let cell = this.#rows.get(name);
    if (cell === undefined) {
      cell = make('dd');
      this.#rows.set(name, cell);
      find('traffic').append(make('dt', name), cell);
    }
    say(cell, value);
  }

  #chart(): void {
    const highest = Math.max(1, ...this.#rates);
    const points = this.#rates.map((rate, i) => `${(i + SECONDS - this.#rates.length) * (120 / (SECONDS - 1))} ${30 - (rate / highest) * 28}`);
    if (points.length < 2) return;
    const first = (SECONDS - this.#rates.length) * (120 / (SECONDS - 1));
    find('traffic-chart').querySelector('.line')!.setAttribute('d', `M${points.join('L')}`);
    find('traffic-chart').querySelector('.area')!.setAttribute('d', `M${first} 32L${points.join('L')}L120 32z`);
  }

  #levels(chunks: readonly number[]): void {
    const list = find('traffic-levels');
    const most = Math.max(1, ...chunks);
    while (list.childElementCount < chunks.length) {
      const item = make('li');
      const level = list.childElementCount;
      item.append(make('span', level === 0 ? 'Full detail' : `1 : ${2 ** level}`), make('meter'), make('span'));
      list.append(item);
    }
    chunks.forEach((number, level) => {
      const [name, meter, figure] = list.children[level]!.children as unknown as [HTMLElement, HTMLMeterElement, HTMLElement];
      meter.max = most;
      meter.value = number;
      meter.setAttribute('aria-label', `${name.textContent}: ${number} chunks`);
      say(figure, count(number));
    });
  }
}
