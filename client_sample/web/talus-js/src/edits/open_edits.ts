// Unanswered edits: under which editor they are sent, and when they are sent again. No I/O.
//
// An edit gets its sequence number when it is first sent. Edits sent again, after a reconnect or because the server
// refused them temporarily, go first, in order and with their number: the server answers with their outcome and applies
// none twice. If the answer is that the edit was not applied but a later one was, it is sent as a new edit.
import type { TalusError } from '../errors.js';
import type { WireEdit } from '../wire/write_edit.js';
import type { EditDone } from './types.js';

export interface OpenEdit {
  readonly edit: WireEdit;
  /** 0: never sent. For an edit to be sent as a new one: the number under which it was sent before. */
  sequence: bigint;
  /** True if it was sent, and is not known to be unapplied. */
  sentBefore: boolean;
  resolve(done: EditDone): void;
  reject(error: TalusError): void;
}

/** Set in ids of edits, clear in ids of other requests. */
export const EDIT_ID_BIT = 0x8000_0000;
export const NO_EDITOR = '0'.repeat(32);

const bySequence = (a: OpenEdit, b: OpenEdit) => (a.sequence < b.sequence ? -1 : 1);

export class OpenEdits {
  editor = NO_EDITOR;
  seenRevision = 0n;
  private state: 'none' | 'sent' | 'attached' = 'none';
  private lastSequence = 0n;
  private unanswered = 1; // maximum
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

  // ---- editor

  get attachState(): 'none' | 'sent' | 'attached' {
    return this.state;
  }

  attachSent(): void {
    this.state = 'sent';
  }

  /** The server asked to retry later. */
  attachRefused(): void {
    this.state = 'none';
  }

  /** Another connection took over the editor: attach again, unless that is already in progress. */
  expired(): void {
    if (this.state === 'attached') this.state = 'none';
  }

  saw(revision: bigint): void {
    if (revision > this.seenRevision) this.seenRevision = revision;
  }

  /** Returns the edits whose outcome can never be known: an earlier connection sent them as an editor that the server
   *  no longer knows. */
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

  /** Drops the editor, after the server changed its store. Returns the edits already sent. */
  forgetEditor(): OpenEdit[] {
    this.connectionEnded();
    const sent = this.again;
    this.again = [];
    this.editor = NO_EDITOR;
    this.lastSequence = this.seenRevision = 0n;
    return sent;
  }

  // ---- sending

  get hasNext(): boolean {
    return (
      this.state === 'attached' &&
      this.inFlight.size < this.unanswered &&
      (this.again.length > 0 || this.waiting.length > 0)
    );
  }

  /** Marks the next edit as in flight. REQUIRES: hasNext. */
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

  /** Removes an answered edit. */
  take(id: number): OpenEdit {
    const open = this.inFlight.get(id)!;
    this.inFlight.delete(id);
    return open;
  }

  /** To be sent again with its sequence number: it may have been applied. */
  putBack(id: number): void {
    const open = this.take(id);
    open.sentBefore = true;
    this.again = [...this.again, open].sort(bySequence);
  }

  /** Was not applied, and must be: sent before edits never sent, in order among the edits put back here. */
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

  /** Returns the edits that were sent, and the edits that certainly were not applied. */
  takeAll(): { sent: OpenEdit[]; unsent: OpenEdit[] } {
    this.connectionEnded();
    const all = { sent: this.again, unsent: this.waiting };
    this.again = [];
    this.waiting = [];
    return all;
  }
}
