// The page's entry: small, so that the connection does not wait for the rest.
import './connection/early';

void import('./main');
