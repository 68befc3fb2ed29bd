# SPDX-License-Identifier: BSD-3-Clause
"""Two tests of a table of texts that a reader refuses, and of texts that it reads."""


class RefusalRows:
    """Rows: the place, what is refused, a part of the message, what is read. A subclass has errors(place, text)."""

    ROWS = ()

    def test_refused(self):
        for place, refused, why, _ in self.ROWS:
            with self.subTest(refused):
                found = self.errors(place, refused)
                self.assertEqual(len(found), 1, found)
                self.assertIn(why, found[0])

    def test_read(self):
        for place, _, _, read in self.ROWS:
            with self.subTest(read):
                self.assertEqual(self.errors(place, read), [])
