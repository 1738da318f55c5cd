// One GET request: the answer's size is bounded, and every failure is a TalusError.
import { originHint, TalusError, type TalusErrorKind } from '../errors.js';

export class HttpError extends TalusError {
  constructor(
    kind: TalusErrorKind,
    message: string,
    retryAfterMs: number,
    readonly status: number,
    /** An ErrorCode of the protocol; empty if the answer is not from a Talus server. */
    readonly code: string,
  ) {
    super(kind, message, retryAfterMs);
  }
}

const TIMEOUT_MS = 30_000; // between parts of an answer; a server answers within 20 s
const MAX_ERROR_BYTES = 16_384;

export interface Getter {
  readonly fetch: typeof fetch;
  readonly token: string | undefined;
}

/** An answer, and its final URL. */
export interface Got {
  readonly body: Uint8Array;
  readonly url: string;
  /** Talus-Revision, for land being edited just now; null: the URL's revision. */
  readonly revision: string | null;
}

/** `maxBytes`: of the body. */
export async function get(
  { fetch, token }: Getter,
  url: string,
  maxBytes: number,
  signal: AbortSignal,
  method = 'GET',
): Promise<Got> {
  const abort = new AbortController();
  const pass = () => abort.abort();
  let isLate = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const wait = () => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      isLate = true;
      pass();
    }, TIMEOUT_MS);
  };
  signal.addEventListener('abort', pass);
  if (signal.aborted) pass();
  wait();
  try {
    const response = await fetch(url, {
      method,
      signal: abort.signal,
      ...(token === undefined ? {} : { headers: { Authorization: `Bearer ${token}` } }),
    });
    if (!response.ok) throw await failure(response, url);
    const revision = response.headers.get('Talus-Revision');
    return { body: await readBounded(response, maxBytes, url, wait), url: response.url, revision };
  } catch (error) {
    if (error instanceof TalusError) throw error;
    if (signal.aborted) throw new TalusError('cancelled', `the request for ${url} was given up`);
    if (isLate) throw new TalusError('timed_out', `${url} did not answer within ${TIMEOUT_MS / 1_000} s`);
    const cause = (error as { cause?: { message?: string } }).cause?.message ?? (error as Error).message;
    throw new TalusError('unreachable', `${url} cannot be reached: ${cause}${originHint(url)}`);
  } finally {
    signal.removeEventListener('abort', pass);
    clearTimeout(timer);
    abort.abort(); // drops unread data
  }
}

async function readBounded(response: Response, maxBytes: number, url: string, came = () => {}): Promise<Uint8Array> {
  const reader = response.body?.getReader();
  if (reader === undefined) return new Uint8Array(0);
  let body = new Uint8Array(0);
  let count = 0;
  for (;;) {
    const { done, value } = await reader.read();
    came();
    if (done) return body.subarray(0, count);
    if (count + value.length > maxBytes) {
      void reader.cancel().catch(() => {});
      throw new TalusError('broken_protocol', `${url} has more than ${maxBytes} bytes`);
    }
    if (count === 0) {
      body = value; // most answers are one piece
    } else {
      if (count + value.length > body.length) {
        const grown = new Uint8Array(Math.min(maxBytes, Math.max(2 * body.length, count + value.length)));
        grown.set(body.subarray(0, count));
        body = grown;
      }
      body.set(value, count);
    }
    count += value.length;
  }
}

async function failure(response: Response, url: string): Promise<TalusError> {
  let code = '';
  let text = `${url.slice(0, 200)} answered ${response.status}`;
  let retryAfterMs = 1_000 * (Number(response.headers.get('Retry-After')) || 0);
  try {
    const { error } = JSON.parse(new TextDecoder().decode(await readBounded(response, MAX_ERROR_BYTES, url)));
    code = String(error.code);
    text = `the server says: ${String(error.text)}`;
    retryAfterMs = Number(error.retry_after_ms) || retryAfterMs;
  } catch {
    // Not from a Talus server but from a proxy: only the status is known.
  }
  return new HttpError(kindOf(response.status), text, retryAfterMs, response.status, code);
}

function kindOf(status: number): TalusErrorKind {
  if (status === 401 || status === 403) return 'refused';
  if (status === 429 || status >= 500) return 'overloaded';
  return status === 400 ? 'out_of_range' : 'server_failed';
}
