#!/usr/bin/env python3
"""Tests of faults.py on a small made-up tree."""
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import faults  # noqa: E402

CODE = '''#include <vector>
// a + b < c[i]
const char* text = "a + b < 1";
/* x = y + 1; */
static_assert(3 + 4 == 7);
#define SEVEN 7
int area(const Box& box, const std::vector<int>& sizes, int i) {
  assert(i + 1 <
         9);
  int sum = sizes[i] + box.low.x;
  for (int k = 0; k < 12; ++k) sum -= k;
  if (sum > 1'000)
    log(sum);
  total_.push_back(sum);
#if 0
  left = out + 1;
#endif
  return sum * 0.25f;
}
'''
DECLARATIONS = '''#pragma once
struct Box {
  Box(int low);
  double size(int axis = 3) const;
};
'''


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name)
        self.write('rendering/scene/Area.cpp', CODE)
        self.write('rendering/scene/Box.h', DECLARATIONS)
        self.write('rendering/shaders/lib/Area.glsl', CODE.replace('sum', 'part'))
        self.write('io/Area.cpp', CODE.replace('sum', 'bytes'))
        self.write('viewer/Area.cpp', CODE.replace('sum', 'pixels'))

    def write(self, path, text):
        (self.tree / path).parent.mkdir(parents=True, exist_ok=True)
        (self.tree / path).write_text(text)

    def chosen(self, seed='1', count=20):
        return [c[0] if c else None for c in faults.candidates(self.tree, seed, count)]

    def changes(self, kind):
        """The made-up file's faults of a kind, as (line, changed line)."""
        return [(f.line, f.after.strip()) for f in faults.faults_of_file(self.tree, 'rendering/scene/Area.cpp') if f.kind == kind]

    def test_the_same_seed_chooses_the_same_faults(self):
        self.assertEqual(self.chosen(), self.chosen())

    def test_seeds_choose_different_faults(self):
        self.assertGreater(len({tuple(map(str, self.chosen(str(seed)))) for seed in range(8)}), 1)

    def test_every_group_has_every_kind(self):
        self.assertEqual({(f.group, f.kind) for f in self.chosen()}, {(g, k) for g in faults.GROUPS for k in faults.KINDS})

    def test_no_fault_is_a_candidate_twice(self):
        candidates = [f for c in faults.candidates(self.tree, '1', 60) for f in c]
        self.assertEqual(len(candidates), len(set(candidates)))

    def test_a_fault_changes_one_line_of_its_file(self):
        for fault in self.chosen():
            lines = (self.tree / fault.file).read_text().split('\n')
            self.assertEqual(lines[fault.line - 1], fault.before)
            self.assertNotEqual(fault.before.strip(), fault.after.strip())
            self.assertNotIn('\n', fault.after)

    def test_kinds_change_what_they_name(self):
        self.assertIn((11, 'for (int k = 0; k <= 12; ++k) sum -= k;'), self.changes('bound'))
        self.assertIn((12, 'if (sum >= 1\'000)'), self.changes('bound'))
        self.assertIn((11, 'for (int k = 0; k < 12; ++k) sum += k;'), self.changes('sign'))
        self.assertIn((10, 'int sum = sizes[i] - box.low.x;'), self.changes('sign'))
        self.assertIn(self.changes('index'), ([(10, 'int sum = sizes[i + 1] + box.low.x;')], [(10, 'int sum = sizes[i] + box.low.y;')]))
        self.assertIn((18, 'return sum * 0.2525f;'), self.changes('constant'))
        self.assertIn(dict(self.changes('constant'))[12], ('if (sum > 1001)', 'if (sum > 999)'))
        self.assertEqual(self.changes('dropped line'), [(14, '')])  # line 13 is the body of an if

    def test_comments_strings_assertions_and_directives_are_left_out(self):
        lines = {f.line for f in faults.faults_of_file(self.tree, 'rendering/scene/Area.cpp')}
        self.assertEqual(lines, {10, 11, 12, 14, 18})

    def test_headers_that_only_declare_are_left_out(self):
        self.assertEqual(list(faults.faults_of_file(self.tree, 'rendering/scene/Box.h')), [])

    def test_a_moved_file_keeps_its_faults(self):
        def named():
            return [(f.group, f.kind, f.before, f.after) for f in self.chosen()]
        before = named()
        (self.tree / 'rendering/geometry').mkdir()
        (self.tree / 'rendering/scene/Area.cpp').rename(self.tree / 'rendering/geometry/Place.cpp')
        text = (self.tree / 'viewer/Area.cpp').read_text()
        (self.tree / 'viewer/Area.cpp').unlink()
        self.write('viewer/views/Area.cpp', '// A new line above.\n\n' + text.replace('  total_', '    total_'))
        after = named()
        self.assertEqual([tuple(str(word).strip() for word in fault) for fault in before],
                         [tuple(str(word).strip() for word in fault) for fault in after])


if __name__ == '__main__':
    unittest.main()
