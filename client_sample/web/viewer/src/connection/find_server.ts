// Decides where the page's world comes from: the server that the page came from, or the page itself.
import { worldIn } from '../here/world_link';
import { Server } from './server';

/** A link's world is made here, whoever serves the page. What makes it is loaded only then. */
export async function findServer(page: string, token: () => string | null): Promise<Server> {
  const link = worldIn(new URL(page).hash);
  const server = new Server(page, token);
  if (link === null && (await server.isThere())) return server;
  const { Here } = await import('../here/here');
  return new Here(page, link);
}
