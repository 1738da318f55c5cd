"""Where the tests find the client and the vectors; importing it makes `import talus` work from the sources."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "client_sample" / "python"))
