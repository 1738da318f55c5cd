// Keys and buttons of digging and building, active in the world while there are tools.
import type { Vector } from '../engine/engine';
import type { Builder } from './builder';

export interface Gaze {
  eye(): Vector;
  /** Direction through the centre of the picture. */
  ahead(): Vector;
}

/** Keys that call commands, by event.code; keys that need the tools are left to others without them. */
export function editCommands(builder: Builder, { eye, ahead }: Gaze): Record<string, () => void> {
  const whenOn = (action: () => void) => () => {
    if (builder.isOn) action();
  };
  const commands: Record<string, () => void> = {
    KeyV: () => void builder.toggle(),
    KeyR: whenOn(() => builder.nextTool()),
    KeyZ: whenOn(() => builder.undo()),
    KeyI: whenOn(() => builder.sample(eye(), ahead())),
    KeyJ: whenOn(() => builder.turn(-1)),
    KeyL: whenOn(() => builder.turn(1)),
    Backspace: whenOn(() => builder.act(eye(), ahead(), builder.tool !== 'dig')),
  };
  for (let digit = 1; digit <= 9; ++digit) commands[`Digit${digit}`] = whenOn(() => builder.chooseSwatch(digit - 1));
  return commands;
}

/** Ctrl+Z, by habit. */
export function undoByHabit(builder: Builder, isShut: () => boolean): void {
  addEventListener('keydown', (event) => {
    const isField = event.target instanceof HTMLElement && /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName);
    if (event.code !== 'KeyZ' || !(event.ctrlKey || event.metaKey) || event.shiftKey || isField) return;
    if (!builder.isOn || isShut()) return;
    event.preventDefault();
    builder.undo();
  });
}
