// Edits of a client over a stream: sending them, and the server's answers.
import { checking, TalusError } from '../errors.js';
import type { World } from '../types.js';
import type { ServerMessage } from '../wire/messages.js';
import { broken } from '../wire/table.js';
import { attachFrame, editFrame } from '../wire/write_edit.js';
import { checkedEdit } from './checked.js';
import { NO_EDITOR, type OpenEdit, OpenEdits } from './open_edits.js';
import type { Edit, EditDone, EditLimits } from './types.js';

const NO_STORE = '0'.repeat(32);

type Message<K extends ServerMessage['kind']> = Extract<ServerMessage, { kind: K }>;

interface Asker {
  resolve(limits: EditLimits): void;
  reject(error: TalusError): void;
}

/** Error if edits are impossible in this world; null: they may be tried. */
export function noEditsIn(world: World): TalusError | null {
  if (world.storeId === NO_STORE) return new TalusError('refused', 'this server stores no edits');
  return null;
}

const outcomeUnknown = () =>
  new TalusError('outcome_unknown', 'the server knows nothing of this edit any more: it may have happened, or not');

function rejectAll(edits: readonly OpenEdit[], error: TalusError): void {
  for (const { reject } of edits) reject(error);
}

export class EditSession {
  private readonly open = new OpenEdits();
  private askers: Asker[] = [];
  private limits: EditLimits | null = null;
  private storeId: string | null = null;

  /** `wake` is called when there may be something to send. */
  constructor(private readonly wake: () => void) {}

  // ---- the application's requests

  edit(edit: Edit, world: World | null): Promise<EditDone> {
    return new Promise((resolve, reject) => {
      const refusal = world === null ? null : noEditsIn(world);
      if (refusal !== null) throw refusal;
      this.open.add({ edit: checking('edit', () => checkedEdit(edit)), sequence: 0n, sentBefore: false, resolve, reject });
      this.wake();
    });
  }

  askLimits(world: World | null): Promise<EditLimits> {
    return new Promise((resolve, reject) => {
      const refusal = world === null ? null : noEditsIn(world);
      if (refusal !== null) throw refusal;
      if (this.limits !== null) return resolve(this.limits);
      this.askers.push({ resolve, reject });
      this.wake();
    });
  }

  saw(revision: bigint): void {
    this.open.saw(revision);
  }

  // ---- the connection

  joined(world: World, sameWorld: boolean): void {
    const sameStore = this.storeId === null || this.storeId === world.storeId;
    this.storeId = world.storeId;
    const refusal = noEditsIn(world);
    if (!sameStore || refusal !== null) rejectAll(this.open.forgetEditor(), outcomeUnknown());
    if (refusal !== null) this.failAll(refusal);
    else if (!sameWorld && !sameStore) this.failAll(new TalusError('not_applied', 'the server has another world now'));
  }

  connectionEnded(): void {
    this.open.connectionEnded();
    this.limits = null;
  }

  /** Edits sent and not answered may have been applied. */
  failAll(error: TalusError): void {
    const { sent, unsent } = this.open.takeAll();
    rejectAll(sent, error.kind === 'closed' ? error : outcomeUnknown());
    rejectAll(unsent, error);
    for (const { reject } of this.askers.splice(0)) reject(error);
  }

  // ---- sending

  get hasNext(): boolean {
    return this.mustAttach || this.open.hasNext;
  }

  private get mustAttach(): boolean {
    return this.open.attachState === 'none' && (!this.open.isEmpty || this.askers.length > 0);
  }

  /** The next frame; null if there turned out to be nothing to send. REQUIRES: hasNext. */
  next(frameBytes: number): Uint8Array | null {
    if (this.mustAttach) {
      this.open.attachSent();
      return attachFrame(this.open.editor, this.open.seenRevision);
    }
    const { id, open } = this.open.sendNext();
    const frame = editFrame(id, open.sequence, open.edit);
    if (frame.length <= frameBytes) return frame;
    const text = `an edit of ${frame.length} bytes is more than this server takes in a frame (${frameBytes}); divide it`;
    this.open.take(id).reject(new TalusError('out_of_range', text));
    return null;
  }

  // ---- the server's messages

  handleAttached(message: Message<'attached'>): void {
    if (this.open.attachState !== 'sent' || message.editor === NO_EDITOR) {
      throw broken('an Attached that no Attach asked for, or without an editor');
    }
    const { editor, known, lastSequence, revision, limits } = message;
    rejectAll(this.open.attached(editor, known, lastSequence, revision, limits.unanswered), outcomeUnknown());
    this.limits = limits;
    for (const { resolve } of this.askers.splice(0)) resolve(limits);
  }

  handleResult({ id, revision, changed }: Message<'edit_result'>): void {
    if (!this.open.has(id)) throw broken(`an EditResult for request ${id}, which is no edit in flight`);
    this.open.saw(revision);
    this.open.take(id).resolve({ revision, changed });
  }

  /** `comesBack`: to be sent again later. */
  editRefused(message: Message<'error'>, error: TalusError, comesBack: boolean): void {
    const id = message.requestId;
    if (!this.open.has(id)) throw broken(`an Error about request ${id}, which is no edit in flight`);
    if (comesBack) {
      this.open.putBack(id);
    } else if (message.code === 'expired') {
      this.open.putBack(id);
      this.open.expired();
    } else if (message.code === 'not_applied') {
      this.open.sendAsNew(id);
    } else {
      const open = this.open.take(id);
      // For an edit sent before, only a conflict proves that it was not applied.
      open.reject(open.sentBefore && message.code !== 'conflict' ? outcomeUnknown() : error);
    }
  }

  /** Edits need an editor: if the server asks to retry, they wait; otherwise they fail. */
  attachRefused(error: TalusError, comesBack: boolean): void {
    if (this.open.attachState !== 'sent') return;
    this.open.attachRefused();
    if (!comesBack) this.failAll(error);
  }
}
