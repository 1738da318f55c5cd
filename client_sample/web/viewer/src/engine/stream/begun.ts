// A client that connects, and asks for the first View, before there is an engine to hear it.
import { connect, type Chunk, type ChunkKey, type Client, type View } from 'talus';

/** As the engine wants its clients. */
export function clientFor(url: string, token: string | undefined): Client {
  return connect({ url, token, clientName: 'talus-viewer', manualCredit: true });
}

const nameOf = ({ lod, x, y, z }: ChunkKey) => `${lod}/${x}/${y}/${z}`;

export class Begun {
  private readonly chunks = new Map<string, Chunk>();
  private isComplete = false;

  constructor(readonly client: Client) {
    client.on('chunk', this.keep).on('chunkLeft', this.forget).on('viewComplete', this.complete);
  }

  /** Gives what is held of the View; its client is to be heard by the caller from now on. */
  end(): { chunks: Iterable<Chunk>; isComplete: boolean } {
    this.client.off('chunk', this.keep).off('chunkLeft', this.forget).off('viewComplete', this.complete);
    return { chunks: this.chunks.values(), isComplete: this.isComplete };
  }

  private readonly keep = (chunk: Chunk) => void this.chunks.set(nameOf(chunk.key), chunk);
  private readonly forget = (key: ChunkKey) => {
    this.chunks.delete(nameOf(key));
    this.isComplete = false; // another View
  };
  private readonly complete = (_: View) => {
    this.isComplete = true;
  };
}
