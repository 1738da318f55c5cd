"""What each release before wrote is read by this talusd: the folders beside this file, of which README.md tells."""

import json
import pathlib
import shutil
import tempfile
import unittest

from kept import HERE, Log, Server, keys_of, seen, serve, settings, stored, talus, talusd, until, vectors


class Release:
    def __init__(self, folder):
        self.folder = folder
        self.chunks = json.loads((folder / "chunks.json").read_text())
        self.stat = json.loads((folder / "stat.json").read_text())


def of_each_release(test):
    """Runs it for each release, with a data directory of its own."""

    def run(self):
        for release in RELEASES:
            with self.subTest(release.folder.name), tempfile.TemporaryDirectory() as scratch:
                self.scratch = pathlib.Path(scratch)
                self.data = self.scratch / "data"
                test(self, release)

    return run


RELEASES = [Release(folder) for folder in sorted(HERE.glob("v*.*"))]
# Of what a store holds, what its edits make; not its id, its size on disk or its history.
OF_EDITS = ("fingerprint", "hash", "levels", "materials")


class Compatibility(unittest.TestCase):
    def check_world(self, world, release, revisions=True):
        expected, found = release.chunks, seen(world, keys_of(release.chunks))
        if not revisions:
            expected, found = ({key: voxels for key, (_, voxels) in chunks.items()} for chunks in (expected, found))
        self.assertEqual(found, expected)

    def check_stat(self, release, same):
        found = stored(self.data)
        self.assertEqual({name: found[name] for name in same}, {name: release.stat[name] for name in same})

    def test_some_release_is_kept(self):
        self.assertGreater(len(RELEASES), 0)

    @of_each_release
    def test_a_store_is_read_and_goes_on(self, release):
        shutil.copytree(release.folder / "store", self.data)
        talusd("store", "verify", "--data", self.data)
        self.check_stat(release, (*OF_EDITS, "store_id", "position", "revision", "time", "editors", "history"))
        with serve(release.folder, self.data) as server, talus.connect(server.address) as world:
            self.assertEqual(f"{world.store_id.high:016x}{world.store_id.low:016x}", release.stat["store_id"])
            self.check_world(world, release)
            done = world.edit([((4, 50, 4), "planks")])
            self.assertEqual((done.revision, done.changed), (release.stat["revision"] + 1, 1))
        talusd("store", "verify", "--data", self.data)

    @of_each_release
    def test_a_backup_is_restored(self, release):
        talusd("store", "restore", release.folder / "backup", "--data", self.data)
        self.check_stat(release, (*OF_EDITS, "position", "revision", "time"))
        with serve(release.folder, self.data) as server, talus.connect(server.address) as world:
            self.check_world(world, release)

    @of_each_release
    def test_an_export_is_imported(self, release):
        talusd("store", "import", release.folder / "edits.talus", "--data", self.data,
               "--world", release.folder / "world.toml")
        self.check_stat(release, OF_EDITS)
        with serve(release.folder, self.data) as server, talus.connect(server.address) as world:
            self.check_world(world, release, revisions=False)

    @of_each_release
    def test_the_log_of_a_cluster_is_applied(self, release):
        messages = [file.read_bytes() for file in sorted((release.folder / "log").iterdir())]
        with Log(self.scratch, settings(release.folder, self.data)) as log:
            log.replace(messages)
            with Server(**log.settings) as server, talus.connect(server.address) as world:
                newest = max((revision, key) for key, (revision, _) in release.chunks.items())
                until(lambda: seen(world, keys_of([newest[1]]))[newest[1]][0] >= newest[0], "the messages are applied")
                self.check_world(world, release)
        self.check_stat(release, (*OF_EDITS, "revision"))
        # It adds one of its own, by which others know where it stands.
        self.assertGreaterEqual(stored(self.data)["cluster_message"], len(messages))

    @of_each_release
    def test_vectors_of_payloads_and_frames_are_never_changed(self, release):
        now = set(vectors())
        kept = (release.folder / "vectors.txt").read_text().splitlines()
        self.assertGreater(len(kept), 20)
        self.assertEqual([vector for vector in kept if vector not in now], [])


if __name__ == "__main__":
    unittest.main()
