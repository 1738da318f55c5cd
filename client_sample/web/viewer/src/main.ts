// The viewer's page: connects its parts. Each frame: the player's intent, the body's step, the engine's picture.
import { findServer } from './connection/find_server';
import { mark } from './connection/marks';
import { Session, type Trouble } from './connection/session';
import { TokenStore } from './connection/token';
import { Keyboard } from './controls/keyboard';
import { Mouse } from './controls/mouse';
import { Player } from './controls/player';
import { Touch } from './controls/touch';
import { Builder } from './edit/builder';
import { EditBar } from './edit/edit_bar';
import { editCommands, undoByHabit } from './edit/hands';
import type { Engine, Vector } from './engine/engine';
import type { Here } from './here/here';
import { linkTo, worldIn } from './here/world_link';
import { Loop } from './loop';
import { Address } from './place/address';
import { capOf, capped, thisDevice } from './place/device';
import { readCoordinate, readLink, wrapHours, clock, type Mode, type Place } from './place/place';
import { defaults, fromLink, load, mend, save, type Settings } from './place/settings';
import { Traveller } from './place/traveller';
import { find, say, showFocusToTabs } from './ui/dom';
import { Hint } from './ui/hint';
import { Hud, share } from './ui/hud';
import { tellsMore } from './ui/more';
import { Notices } from './ui/notices';
import { Panels } from './ui/panels';
import { SettingsPanel } from './ui/settings_panel';
import { SharePanel } from './ui/share_panel';
import { SLICE_FARTHEST, SlicePanel } from './ui/slice_panel';
import { TokenDialog } from './ui/token_dialog';
import { TrafficPanel } from './ui/traffic_panel';
import { WorldsPanel } from './ui/worlds_panel';
import { FIELD_OF_VIEW, rayThrough, VoxelCard } from './ui/voxel_card';

const device = thisDevice();
const isPhone = device.isCoarse;
const cap = capOf(device);
const isReducedBySystem = matchMedia('(prefers-reduced-motion: reduce)');
const storage = () => localStorage;
const DAY_S = 24 * 60;
const SPAWN_PITCH = -8;

let kept = load(defaults(isPhone), storage);
const settings: Settings = capped(mend(kept, fromLink(location.hash)), cap);
const isReduced = () => settings.reducedMotion ?? isReducedBySystem.matches;

const tokens = new TokenStore();
const server = await findServer(location.href, () => tokens.token);
const isHere = server.source !== null;
const world = worldIn(location.hash);
const player = new Player();
const { body } = player;
const address = new Address();
const stage = find('stage');
let engine: Engine | null = null;
let hours = readLink(location.hash).time ?? 10.5;

// --- Place ---

const traveller = new Traveller(body, server, () => engine);
const place = () => traveller.place(hours);

function follow(link: Partial<Place>): void {
  body.mode = link.mode ?? body.mode;
  body.yaw = link.yaw ?? body.yaw;
  body.pitch = link.pitch ?? body.pitch;
  if (link.time !== undefined) setTime(link.time);
  if (link.x !== undefined && link.z !== undefined)
    traveller.to(link.x, link.y ?? null, link.z).catch((error: Error) => {
      hud.status(error.message, 'bad');
      if (!traveller.isPlaced) traveller.toSpawn();
    });
  else if (!traveller.isPlaced) {
    traveller.toSpawn();
    if (link.yaw === undefined) void traveller.lookOut();
  }
}

addEventListener('hashchange', () => {
  if (worldIn(location.hash) !== world) location.reload();
  else follow(readLink(location.hash));
});
addEventListener('pagehide', () => {
  if (traveller.isPlaced) address.write(place());
});

// --- Light ---

const timeField = find<HTMLInputElement>('time');
const timeRuns = find<HTMLInputElement>('time-runs');

function setTime(to: number): void {
  hours = wrapHours(to);
  engine?.setTimeOfDay(hours);
  timeField.value = String(hours);
  say(find('time-now'), clock(hours));
}

timeField.addEventListener('input', () => setTime(Math.min(23.99, Number(timeField.value))));
timeRuns.checked = settings.timeRuns;
timeRuns.addEventListener('change', () => change({ timeRuns: timeRuns.checked }));

// --- Settings ---

function change(wanted: Partial<Settings>): void {
  const changed = capped(wanted, cap);
  Object.assign(settings, changed);
  kept = { ...kept, ...changed };
  save(kept, storage);
  if ('transport' in changed) void session.open();
  if ('radius' in changed || 'horizon' in changed) engine?.setRadius(settings.radius, settings.horizon);
  if ('quality' in changed) {
    engine?.setQuality(settings.quality);
    resize();
  }
  if ('reducedMotion' in changed) applyMotion();
  if ('chunkBorders' in changed) applyBorders();
  timeRuns.checked = settings.timeRuns;
}

function applyMotion(): void {
  engine?.setReducedMotion(isReduced());
  document.body.classList.toggle('moves', !isReduced());
}
isReducedBySystem.addEventListener('change', applyMotion);

const bordersField = find<HTMLInputElement>('borders');
function applyBorders(): void {
  bordersField.checked = settings.chunkBorders;
  engine?.setChunkBorders(settings.chunkBorders);
}
bordersField.addEventListener('change', () => change({ chunkBorders: bordersField.checked }));

// --- Parts of the page ---

const toStage = () => stage.focus({ preventScroll: true });
const panels = new Panels(toStage);
const hud = new Hud(isHere);
const hint = new Hint(toStage);
const traffic = new TrafficPanel(isHere);
const voxel = new VoxelCard();
const slice = new SlicePanel(
  () => ({ x: body.position[0], z: body.position[2], yaw: body.yaw, seen: seenAhead() }),
  (plane) => engine?.setSlice(plane),
);
new SettingsPanel(settings, change, isPhone, cap);
new SharePanel(() => engine?.screenshot() ?? null, place, () => address.write(place()));
const tokenDialog = new TokenDialog(tokens, () => {
  session.again();
  void builder.ask();
});
find('token-change').addEventListener('click', () => tokenDialog.ask('The next connection uses it.'));

const help = find<HTMLDialogElement>('help');
for (const box of document.querySelectorAll<HTMLElement>('.panel, #help, #notice')) tellsMore(box);
const openHelp = () => {
  document.exitPointerLock?.();
  help.showModal();
};
find('open-help').addEventListener('click', openHelp);
help.addEventListener('close', toStage);

find('goto-form').addEventListener('submit', (event) => {
  event.preventDefault();
  const to = readCoordinate(find<HTMLInputElement>('goto-text').value);
  const wrong = find('goto-wrong');
  if (to === null) return say(wrong, 'Two or three numbers, such as 1200 -340 or 1200 90 -340.');
  say(wrong, '');
  traveller.to(to.x, to.y, to.z).then(
    () => panels.close(),
    (error: Error) => say(wrong, error.message),
  );
});
find('goto-spawn').addEventListener('click', () => (traveller.toSpawn(), panels.close()));

// --- Digging and building ---

const editBar = new EditBar(toStage);
const builder = new Builder(body, { changed: () => editBar.show(), say: (text, isBad) => editBar.say(text, isBad) });
editBar.attach(builder);

// --- The connection ---

const notices = new Notices({
  retry: () => session.hurry(),
  again: () => session.again(),
  reload: () => void session.open(),
  byHttp: () => change({ transport: 'http' }),
  askToken: (why) => tokenDialog.ask(why),
  toSpawn: () => traveller.toSpawn(),
  openDefault: () => (location.hash = linkTo(null, location.hash)),
});
if (isHere) new WorldsPanel(server as Here, (why) => notices.notKept(why));

const session = new Session(stage, settings, server, tokens, isReduced, {
  opened(opened) {
    engine = opened;
    document.body.classList.remove('empty');
    player.enter(opened);
    builder.enter(opened);
    opened.setFov(FIELD_OF_VIEW);
    resize();
    opened.setTimeOfDay(hours);
    opened.setSlice(slice.slice);
    applyMotion();
    applyBorders();
    if (!traveller.isPlaced) follow(startingPlace());
    hud.opening('The land is on its way', null);
    say(find('help-world'), `${isHere ? 'Made in this page' : opened.world.server}, world ${opened.world.fingerprint}`);
  },
  closing() {
    engine = null;
    document.body.classList.add('empty');
    player.enter(null);
    builder.enter(null);
    voxel.clear();
  },
  trouble(trouble: Trouble | null) {
    notices.trouble(trouble);
    if (trouble === null) return;
    const words: Record<Trouble['kind'], string> = {
      away: 'Server away',
      token: 'No access',
      refused: 'Refused',
      'no-world': 'No world',
      'no-socket': 'No connection',
      'no-webgl': 'No 3D',
      'graphics-lost': 'No graphics',
    };
    hud.status(words[trouble.kind], 'bad');
    if (trouble.kind === 'away') hud.opening('Waiting for the server', null);
    else hud.opened();
  },
  worldChanged(world) {
    voxel.clear();
    builder.enter(engine);
    say(find('help-world'), `${world.server}, world ${world.fingerprint}`);
    notices.worldChanged();
  },
});

function startingPlace(): Partial<Place> {
  const link = readLink(location.hash);
  return { pitch: SPAWN_PITCH, mode: 'fly' satisfies Mode, ...link };
}

function resize(): void {
  // More pixels are expensive and barely visible.
  const pixels = Math.min(devicePixelRatio, settings.quality === 'high' ? 2 : 1);
  engine?.resize(stage.clientWidth, stage.clientHeight, pixels);
}
addEventListener('resize', resize);

// --- Input ---

const eye = (): Vector => {
  const [x, y, z] = body.eye;
  return { x, y, z };
};

/** Selects the voxel there; with editing tools, applies them there. */
function pick(x: number, y: number, other = false): void {
  if (engine === null) return;
  const half = stage.clientHeight / 2;
  const direction = rayThrough(body.yaw, body.pitch, (x - stage.clientWidth / 2) / half, 1 - y / half);
  if (builder.isOn) builder.act(eye(), direction, other);
  else voxel.hold(engine, eye(), direction);
}
/** Horizontal distance in blocks to the centre of the screen; null: nothing near, or the eye is inside a voxel. */
function seenAhead(): number | null {
  const hit = engine?.raycast(eye(), gaze.ahead(), SLICE_FARTHEST, true) ?? null;
  return hit === null || hit.distance === 0 ? null : hit.distance * Math.cos((body.pitch * Math.PI) / 180);
}
const pickAhead = () => pick(stage.clientWidth / 2, stage.clientHeight / 2);

const gaze = { eye, ahead: () => rayThrough(body.yaw, body.pitch, 0, 0) };
const speedUp = (notches: number) => player.changeSpeed(notches);
const turnWheel = (notches: number, shift: boolean) => (builder.isOn && !shift ? builder.turn(-notches) : speedUp(notches));
const commands: Record<string, () => void> = {
  ...editCommands(builder, gaze),
  KeyF: () => player.toggleMode(),
  KeyM: () => openMap(),
  KeyG: () => panels.toggle('goto'),
  KeyT: () => panels.toggle('time'),
  KeyX: () => (slice.slice === null ? slice.cutHere() : slice.off()),
  BracketLeft: () => slice.move(-1),
  BracketRight: () => slice.move(1),
  KeyP: () => panels.toggle('traffic', false),
  KeyB: () => change({ chunkBorders: !settings.chunkBorders }),
  KeyK: () => panels.toggle('share'),
  KeyO: () => panels.toggle('settings'),
  KeyU: () => document.body.classList.toggle('bare'),
  KeyH: openHelp,
  '?': openHelp,
  Home: () => (body.pitch = 0),
  Comma: () => setTime(hours - 0.25),
  Period: () => setTime(hours + 0.25),
  '+': () => speedUp(1),
  '-': () => speedUp(-1),
  Enter: () => (builder.isOn || voxel.held === null ? pickAhead() : voxel.letGo()),
  Escape: () => panels.close() || builder.cancel() || voxel.letGo(),
};

const isShut = () => help.open || find<HTMLDialogElement>('token').open || !find('map').hidden;
player.add(new Keyboard(commands, isShut));
undoByHabit(builder, isShut);
player.add(new Mouse(stage, settings, pick, turnWheel, () => builder.isOn));
const touch = new Touch(stage, find('stick'), settings, pick, () => {
  document.body.classList.add('touched');
  find('thumbs').hidden = false;
});
touch.hold(find('thumb-up'), 1);
touch.hold(find('thumb-down'), -1);
find('thumb-mode').addEventListener('click', () => player.toggleMode());
player.add(touch);
if (isPhone) {
  document.body.classList.add('touched');
  find('thumbs').hidden = false;
}
addEventListener('blur', () => player.release());

// --- The map ---

async function openMap(): Promise<void> {
  document.exitPointerLock?.();
  player.release();
  const { openMapOverlay } = await import('./map/overlay');
  openMapOverlay(find('map'), server, {
    place,
    world: () => engine?.world ?? null,
    go: (x, z) => traveller.to(x, null, z),
    closed: toStage,
  });
}
find('open-map').addEventListener('click', () => void openMap());

// --- Every frame ---

let told = 0;
let inspected = 0;
let hasPicture = false;
const loop = new Loop({
  // The first picture is shown at once.
  cap: () => (isFirstPicture() ? 0 : settings.frameRate),
  step(now, seconds) {
    if (settings.timeRuns) setTime(hours + (seconds * 24) / DAY_S);
    if (traveller.isPlaced) player.step(seconds);
    if (engine !== null && traveller.isPlaced) {
      traveller.surface(engine);
      traveller.emerge();
      traveller.turnFromWhatIsNear(engine);
      player.look(engine);
      builder.look(eye(), gaze.ahead());
      if (now - inspected > 100) {
        inspected = now;
        voxel.look(engine, eye(), body.yaw, body.pitch);
      }
      address.follow(now, place());
    }
    if (now - told > 250) {
      told = now;
      tell(now);
    }
  },
  update() {
    if (engine !== null && traveller.isPlaced) engine.update();
  },
  draw(now) {
    if (engine !== null && traveller.isPlaced) engine.frame(now);
  },
});

function isFirstPicture(): boolean {
  if (hasPicture || engine === null) return false;
  const stats = engine.stats();
  hasPicture = stats.hasPicture;
  return stats.meshes > 0 && !hasPicture;
}

function tell(now: number): void {
  notices.tick(now);
  if (engine === null) return;
  const stats = engine.stats();
  mark(stats, session.began);
  hud.connection(stats);
  editBar.waits(stats.state === 'lost' ? builder.waiting : 0);
  hud.where(place(), body);
  if (stats.hasPicture || stats.state === 'complete') hud.opened();
  else hud.opening('The land is on its way', share(stats));
  hint.tick(now, stats.state === 'complete' && !panels.isAnyOpen, player.hasMoved);
  traffic.update(stats, now, loop.framesPerSecond, panels.isOpen('traffic'));
}

setTime(hours);
applyMotion();
applyBorders();
showFocusToTabs();
hud.opening(isHere ? 'Making the world' : 'Connecting', null);
hud.status(isHere ? 'Opening' : 'Connecting', 'busy');
toStage();
loop.start();
void session.open();

// For the console, and for tests.
declare global {
  interface Window {
    talus: { readonly engine: Engine | null; readonly player: Player; readonly settings: Settings; readonly builder: Builder; pick: (x: number, y: number) => void };
  }
}
window.talus = {
  get engine() {
    return engine;
  },
  player,
  settings,
  builder,
  pick,
};
