"""The chunks of a View against core/voxel/vectors/views.json."""

import json
import unittest

from paths import ROOT

from talus.view_shape import level_boxes

VIEWS = json.loads((ROOT / "core/voxel/vectors/views.json").read_text())["views"]


def ends(part):
    return [part[0], part[-1]] if len(part) else None


class Vectors(unittest.TestCase):
    def test_views(self):
        for view in VIEWS:
            with self.subTest(view["name"]):
                horizon = view.get("horizon")
                arguments = (
                    [int(c) for c in view["centre"]],
                    view["horizontal_radius"],
                    view["vertical_radius"],
                    [(ring["lod"], ring["radius"]) for ring in view["rings"]],
                    horizon and (int(horizon["min_y"]), int(horizon["max_y"])),
                )
                boxes = level_boxes(*arguments)
                self.assertEqual(sum(map(len, boxes)), view["chunks"])
                self.assertEqual(sum(map(len, level_boxes(*arguments, cut=False))), view["chunks_without_edge"])
                self.assertEqual(len(boxes), len(view["levels"]))
                for box, level in zip(boxes, view["levels"]):
                    self.assertEqual(len(box), level["chunks"])
                    if len(box):
                        found = {name: ends(getattr(box, name)) for name in ("x", "y", "z", "inner_x", "inner_z")}
                        expected = {name: level[name] for name in found}
                        if None in (expected["inner_x"], expected["inner_z"]):
                            self.assertIn(None, (found.pop("inner_x"), found.pop("inner_z")))
                        self.assertEqual(found, {name: expected[name] for name in found})
                for lod, x, y, z in view["inside"]:
                    self.assertTrue(any((x, y, z, lod) in box for box in boxes), (lod, x, y, z))
                for lod, x, y, z in view["outside"]:
                    self.assertFalse(any((x, y, z, lod) in box for box in boxes), (lod, x, y, z))


if __name__ == "__main__":
    unittest.main()
