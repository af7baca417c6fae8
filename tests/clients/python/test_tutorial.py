"""Every block of the tutorial runs, in its order, as written."""

import os
import re
import unittest

from support import ROOT, ServerTest

import lares

TUTORIAL = ROOT / "clients/python/TUTORIAL.md"


class TutorialTest(ServerTest):
    def test_every_block_runs(self) -> None:
        text = TUTORIAL.read_text("utf-8")
        blocks = re.findall(r"^```python\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
        self.assertEqual(text.count("```"), 2 * len(blocks), "a block that is not run")
        os.environ["LARES_SERVER"] = self.server.url
        self.addCleanup(os.environ.pop, "LARES_SERVER")
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(ROOT)
        names: "dict[str, object]" = {"lares": lares}
        for block in blocks:
            with self.subTest(block=block):
                exec(compile(block, str(TUTORIAL), "exec"), names)


if __name__ == "__main__":
    unittest.main()
