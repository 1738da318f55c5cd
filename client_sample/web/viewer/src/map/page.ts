// The map's own page: works without WebGL, and links to the viewer.
import { findServer } from '../connection/find_server';
import type { Obstacle } from '../connection/server';
import { TokenStore } from '../connection/token';
import { readLink, writeLink, type Place } from '../place/place';
import { find, showFocusToTabs } from '../ui/dom';
import { TokenDialog } from '../ui/token_dialog';
import { MapScreen } from './screen';

const FIRST_ZOOM = 9;
const RETRY_MS = 2000;

const tokens = new TokenStore();
const server = await findServer(location.href, () => tokens.token);
const link = readLink(location.hash);
const toViewer = (hash: string) => location.assign(new URL('./' + hash, server.base).href);

function linkTo(x: number, z: number): string {
  const place: Place = { yaw: 0, pitch: -8, time: 10.5, mode: 'fly', ...link, x, y: null, z };
  return writeLink(place, location.hash);
}

const screen = new MapScreen(find('map'), server, { x: link.x ?? 0, z: link.z ?? 0, zoom: FIRST_ZOOM }, {
  go: (x, z) => toViewer(linkTo(x, z)),
  close: () => toViewer(location.hash),
  token: () => dialog.ask('The map is drawn for those who have one.'),
});
const dialog = new TokenDialog(tokens, () => location.reload());

const WORDS: Record<Obstacle['kind'], (text: string) => string> = {
  away: () => 'The server is away. Trying again.',
  token: () => 'The server asks for a token.',
  'no-world': (text) => `This link opens no world: ${text}.`,
  blocked: (text) => `The server refuses: ${text}.`,
  other: (text) => `This is no Talus server: ${text}.`,
};

async function open(): Promise<void> {
  try {
    const { fingerprint, spawn } = await server.world();
    const [x, , z] = spawn;
    screen.setWorld({ fingerprint, spawn: { x: x + 0.5, z: z + 0.5 } });
    if (link.x === undefined) screen.centre({ x, z });
    screen.say('');
  } catch {
    const obstacle = await server.obstacle();
    if (obstacle !== null) {
      screen.say(WORDS[obstacle.kind](obstacle.text));
      if (obstacle.kind === 'token') return dialog.ask(obstacle.text);
    }
    setTimeout(() => void open(), RETRY_MS);
  }
}

if (link.x !== undefined && link.z !== undefined) screen.setPlayer({ x: link.x, z: link.z, yaw: link.yaw ?? 0 });
showFocusToTabs();
screen.focus();
void open();

declare global {
  interface Window {
    talusMap: MapScreen;
  }
}
window.talusMap = screen;
