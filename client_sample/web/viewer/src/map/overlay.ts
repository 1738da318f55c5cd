// The map over the viewer, while the world goes on behind it.
import type { Server } from '../connection/server';
import type { Place } from '../place/place';
import { MapScreen, type MapWorld } from './screen';

export interface Viewer {
  place: () => Place;
  world: () => MapWorld | null;
  go: (x: number, z: number) => Promise<void>;
  closed: () => void;
}

const FIRST_ZOOM = 10;

export function openMapOverlay(host: HTMLElement, server: Server, viewer: Viewer): void {
  const { x, z, yaw } = viewer.place();
  host.hidden = false;
  const timer = setInterval(() => screen.setPlayer(viewer.place()), 500);
  const close = () => {
    clearInterval(timer);
    screen.dispose();
    host.hidden = true;
    viewer.closed();
  };
  const screen = new MapScreen(host, server, { x, z, zoom: FIRST_ZOOM }, {
    close,
    go: (toX, toZ) =>
      void viewer.go(toX, toZ).then(close, (error: Error) => screen.say(`No way there: ${error.message}.`)),
  });
  const world = viewer.world();
  if (world !== null) screen.setWorld(world);
  else screen.say('The server is away.');
  screen.setPlayer({ x, z, yaw });
  screen.focus();
}
