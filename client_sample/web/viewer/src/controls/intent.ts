// A player's intent in a frame, from any device.

export interface Intent {
  /** -1 to 1 each. */
  forward: number;
  right: number;
  up: number;
  /** Rates of turning, -1 to 1: keys and sticks. */
  turn: number;
  tilt: number;
  /** Degrees turned in this frame: mouse and fingers. */
  yaw: number;
  pitch: number;
  fast: boolean;
}

export const rest = (): Intent => ({ forward: 0, right: 0, up: 0, turn: 0, tilt: 0, yaw: 0, pitch: 0, fast: false });

/** A device adds what it has to the frame's intent. */
export interface Device {
  read(intent: Intent): void;
  /** Releases everything held: the page lost the focus, so it will miss the release. */
  release(): void;
}
