"""tools/make_scenes writes the files of scenes/ again, byte for byte, and no others."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["CLEAVE_SOURCE"])


def scenes_in(folder):
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in folder.rglob("*") if path.suffix in (".glb", ".gltf")}


class MakeScenes(unittest.TestCase):
    def test_writes_what_is_committed(self):
        with tempfile.TemporaryDirectory() as folder:
            # Hashes of strings differ from run to run: no order may hang on them.
            for seed in ("1", "2"):
                subprocess.run([sys.executable, SOURCE / "tools/make_scenes", folder], check=True,
                               env={**os.environ, "PYTHONHASHSEED": seed})
                made, committed = scenes_in(pathlib.Path(folder)), scenes_in(SOURCE / "scenes")
                self.assertEqual(sorted(made), sorted(committed))
                for name, data in committed.items():
                    self.assertTrue(made[name] == data, f"{name} differs from what is committed")


if __name__ == "__main__":
    unittest.main()
