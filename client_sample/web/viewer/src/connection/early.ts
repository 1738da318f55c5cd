// The connection begins, and the land of the first View is asked for, before the engine is loaded: the server works on
// it while the browser compiles the rest and sets up its graphics.
import { Begun, clientFor } from '../engine/stream/begun';
import { directionOf, viewFor } from '../engine/stream/shape';
import { firstEye } from '../place/arrival';
import { readLink } from '../place/place';
import { defaults, fromLink, load, mend, type Settings } from '../place/settings';
import { TokenStore } from './token';

export const isPhone = matchMedia('(pointer: coarse)').matches;
export const kept = load(defaults(isPhone), () => localStorage);
/** Those of the link win. */
export const settings: Settings = mend(kept, fromLink(location.hash));
export const tokens = new TokenStore();

const radians = Math.PI / 180;

function begin(): Begun | null {
  if (settings.transport !== 'websocket') return null;
  const url = new URL('./', location.href);
  url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
  url.hash = url.search = '';
  const client = clientFor(url.href.replace(/\/$/, ''), tokens.token ?? undefined);
  const ask = () => {
    client.off('connected', ask);
    const world = client.world!;
    const eye = firstEye(readLink(location.hash), world.spawn);
    if (eye === null) return;
    try {
      client.setView(viewFor(world, eye, directionOf(eye.yaw * radians, eye.pitch * radians), settings.radius, settings.horizon));
    } catch {
      // Over the server's limits: the engine tells.
    }
  };
  client.on('connected', ask);
  return new Begun(client);
}

let begun = begin();

/** For the page's first engine. */
export function takeBegun(): Begun | null {
  const taken = begun;
  begun = null;
  return taken;
}
