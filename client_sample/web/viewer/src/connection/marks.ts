// For measurements: when the first terrain was submitted, and when all of the view was. From the address on, in ms.
import type { Stats } from '../engine/engine';

const marked = new Set<string>();

/** `began`: when the engine was asked for, of performance.now(). Each is marked once a page. */
export function mark(stats: Stats, began: number): void {
  const marks: [string, number | null][] = [['talus:first', stats.firstFrameMs], ['talus:complete', stats.completeMs]]; // prettier-ignore
  for (const [name, since] of marks) {
    if (since === null || marked.has(name)) continue;
    marked.add(name);
    performance.mark(name, { startTime: began + since });
  }
}
