// Performance marks: submission of the first terrain, and of the complete view, in ms from navigation.
import type { Stats } from '../engine/engine';

const marked = new Set<string>();

/** `began`: when the engine was requested, as performance.now(). Each mark is set once per page. */
export function mark(stats: Stats, began: number): void {
  const marks: [string, number | null][] = [['talus:first', stats.firstFrameMs], ['talus:complete', stats.completeMs]]; // prettier-ignore
  for (const [name, since] of marks) {
    if (since === null || marked.has(name)) continue;
    marked.add(name);
    performance.mark(name, { startTime: began + since });
  }
}
