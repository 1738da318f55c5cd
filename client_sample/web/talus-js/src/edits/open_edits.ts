// Edits that have no answer yet, as which editor they are sent, and what is sent again when. No I/O.
//
// An edit gets its sequence when it is first sent. What is sent again, after a new connection or as the server refused it
// for now, goes first, in order and with its sequence: the server answers by what became of it, and does none twice. Where
// it says that the edit did not happen, and a later one did, it goes as a new one.
import type { TalusError } from '../errors.js';
import type { WireEdit } from '../wire/write_edit.js';
import type { EditDone } from './types.js';

export interface OpenEdit {
  readonly edit: WireEdit;
  /** 0: never sent. Of one that waits to be sent as a new one: that under which it was sent before. */
  sequence: bigint;
  /** It was, and is not known since not to have happened. */
  sentBefore: boolean;
  resolve(done: EditDone): void;
  reject(error: TalusError): void;
}

/** Ids of edits have this bit, those of other requests do not. */
export const EDIT_ID_BIT = 0x8000_0000;
export const NO_EDITOR = '0'.repeat(32);

const bySequence = (a: OpenEdit, b: OpenEdit) => (a.sequence < b.sequence ? -1 : 1);

export class OpenEdits {
  editor = NO_EDITOR;
  seenRevision = 0n;
  private state: 'none' | 'sent' | 'attached' = 'none';
  private lastSequence = 0n;
  private unanswered = 1; // at most
  private waiting: OpenEdit[] = []; // never sent, or to be sent as new
  private again: OpenEdit[] = []; // sent by an earlier connection
  private readonly inFlight = new Map<number, OpenEdit>();
  private lastId = 0;

  add(edit: OpenEdit): void {
    this.waiting.push(edit);
  }

  get isEmpty(): boolean {
    return this.waiting.length === 0 && this.again.length === 0 && this.inFlight.size === 0;
  }

  // ---- as which editor

  get attachState(): 'none' | 'sent' | 'attached' {
    return this.state;
  }

  attachSent(): void {
    this.state = 'sent';
  }

  /** The server asked to come back. */
  attachRefused(): void {
    this.state = 'none';
  }

  /** Another connection took the editor: Attach once more, unless that is on its way already. */
  expired(): void {
    if (this.state === 'attached') this.state = 'none';
  }

  saw(revision: bigint): void {
    if (revision > this.seenRevision) this.seenRevision = revision;
  }

  /** Gives the edits of which nobody will ever say whether they happened: an earlier connection sent them, as an editor
   *  that the server does not know any more. */
  attached(editor: string, known: boolean, lastSequence: bigint, revision: bigint, unanswered: number): OpenEdit[] {
    const lost = known ? [] : this.again;
    if (!known) {
      this.again = [];
      this.lastSequence = 0n;
    }
    this.state = 'attached';
    this.editor = editor;
    if (lastSequence > this.lastSequence) this.lastSequence = lastSequence;
    this.unanswered = Math.max(1, unanswered);
    this.saw(revision);
    return lost;
  }

  /** Another store: nothing is left of the editor, nor of its edits. Gives those that were sent. */
  forgetEditor(): OpenEdit[] {
    this.connectionEnded();
    const sent = this.again;
    this.again = [];
    this.editor = NO_EDITOR;
    this.lastSequence = this.seenRevision = 0n;
    return sent;
  }

  // ---- what to send

  get hasNext(): boolean {
    return (
      this.state === 'attached' &&
      this.inFlight.size < this.unanswered &&
      (this.again.length > 0 || this.waiting.length > 0)
    );
  }

  /** The next one, in flight from now on. REQUIRES: hasNext. */
  sendNext(): { id: number; open: OpenEdit } {
    let open = this.again.shift();
    if (open === undefined) {
      open = this.waiting.shift()!;
      open.sequence = ++this.lastSequence;
    }
    do this.lastId = (this.lastId + 1) % EDIT_ID_BIT;
    while (this.inFlight.has(EDIT_ID_BIT + this.lastId));
    const id = EDIT_ID_BIT + this.lastId;
    this.inFlight.set(id, open);
    return { id, open };
  }

  has(id: number): boolean {
    return this.inFlight.has(id);
  }

  /** It is answered. */
  take(id: number): OpenEdit {
    const open = this.inFlight.get(id)!;
    this.inFlight.delete(id);
    return open;
  }

  /** It is to be sent again as it is: it may have happened. */
  putBack(id: number): void {
    const open = this.take(id);
    open.sentBefore = true;
    this.again = [...this.again, open].sort(bySequence);
  }

  /** It did not happen, and shall: before those never sent, and in order among those that were put there. */
  sendAsNew(id: number): void {
    const open = this.take(id);
    open.sentBefore = false;
    const after = this.waiting.findIndex(({ sequence }) => sequence === 0n || sequence > open.sequence);
    this.waiting.splice(after < 0 ? this.waiting.length : after, 0, open);
  }

  /** The connection broke. */
  connectionEnded(): void {
    this.state = 'none';
    for (const open of this.inFlight.values()) open.sentBefore = true;
    this.again = [...this.again, ...this.inFlight.values()].sort(bySequence);
    this.inFlight.clear();
  }

  /** Gives those that were sent, and those that certainly did not happen. */
  takeAll(): { sent: OpenEdit[]; unsent: OpenEdit[] } {
    this.connectionEnded();
    const all = { sent: this.again, unsent: this.waiting };
    this.again = [];
    this.waiting = [];
    return all;
  }
}
