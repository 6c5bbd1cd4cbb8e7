"""The checker itself: made-up files that break one rule each, and their neighbours that do not."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import check
import functions
import house
import rules


def messages(path, *lines):
    return [message for _, message in rules.findings(path, "\n".join(lines))]


class IncludeDirections(unittest.TestCase):
    def test_every_include_to_the_right_is_found(self):
        for i, own in enumerate(rules.FOLDERS):
            for target in rules.FOLDERS[i + 1 :]:
                found = messages(f"{own}/a.cpp", f'#include "{target}/b.hpp"')
                self.assertEqual(len(found), 1, (own, target))
                self.assertIn(f"{own} must not include {target}/b.hpp", found[0])

    def test_own_folder_and_folders_to_the_left_are_free(self):
        for i, own in enumerate(rules.FOLDERS):
            for target in rules.FOLDERS[: i + 1]:
                self.assertEqual(messages(f"{own}/deep/a.hpp", f'#include "{target}/b.hpp"'), [])

    def test_other_spellings_are_found(self):
        for line in ('#include <models/law.hpp>', ' #  include "models/law.hpp"', '#include "../models/law.hpp"'):
            self.assertEqual(len(messages("meshing/a.cpp", line)), 1, line)

    def test_line_number(self):
        text = '#pragma once\n\n#include "studies/main.hpp"\n'
        self.assertEqual([line for line, _ in rules.findings("models/a.hpp", text)], [3])

    def test_a_comment_and_a_string_are_no_includes(self):
        self.assertEqual(messages("meshing/a.cpp", '// #include "models/law.hpp"', 'f("#include <mpi.h>");'), [])

    def test_tests_include_everything(self):
        self.assertEqual(messages("tests/unit/a.cpp", '#include "studies/a.hpp"', "#include <mpi.h>"), [])


class Libraries(unittest.TestCase):
    # One header of each kind; the file that may include it comes second.
    HEADERS = (
        ("gmsh.h", "meshing/gmsh/a.cpp"),
        ("geos_c.h", "meshing/a.cpp"),
        ("hdf5.h", "framework/files/a.cpp"),
        ("yaml.h", "framework/a.cpp"),
        ("zlib.h", "framework/a.cpp"),
        ("NOX_Utils.H", "continuation/a.hpp"),
        ("LOCA_Stepper.H", "continuation/a.hpp"),
        ("LOCA.H", "continuation/a.cpp"),
        ("Tpetra_Vector.hpp", "continuation/a.hpp"),
        ("Teuchos_RCP.hpp", "continuation/a.hpp"),
        ("Amesos2.hpp", "continuation/a.cpp"),
        ("Thyra_VectorBase.hpp", "continuation/a.cpp"),
        ("AnasaziBlockKrylovSchur.hpp", "continuation/a.cpp"),
        ("dmumps_c.h", "continuation/a.cpp"),
        ("cholmod.h", "continuation/a.cpp"),
        ("mpi.h", "continuation/a.hpp"),
        ("CLI/CLI.hpp", "studies/dda/main.cpp"),
    )

    def test_each_is_free_in_its_folder(self):
        for header, home in self.HEADERS:
            self.assertEqual(messages(home, f"#include <{header}>"), [], header)

    def test_each_is_found_in_every_other_folder(self):
        for header, home in self.HEADERS:
            for folder in rules.FOLDERS:
                if folder != rules.folder_of(home):
                    found = messages(f"{folder}/a.cpp", f"#include <{header}>")
                    self.assertEqual(len(found), 1, (header, folder))

    def test_headers_hide_what_belongs_into_cpp_files(self):
        for header in ("gmsh.h", "geos_c.h", "hdf5.h", "yaml.h", "zlib.h"):
            home = dict(self.HEADERS)[header].replace(".cpp", ".hpp")
            self.assertIn(".cpp files only", messages(home, f"#include <{header}>")[0])

    def test_free_libraries(self):
        for folder in rules.FOLDERS:
            found = messages(f"{folder}/a.hpp", "#include <Eigen/Core>", "#include <fmt/format.h>", "#include <map>")
            self.assertEqual(found, [])


class Text(unittest.TestCase):
    def test_length(self):
        self.assertEqual(messages("models/a.cpp", *["int a;"] * 400), [])
        self.assertIn("401 lines", messages("models/a.cpp", *["int a;"] * 401)[0])

    def test_unfinished_work(self):
        for word in ("TO" + "DO", "FIX" + "ME"):
            self.assertEqual(len(messages("tests/a.cpp", f"// {word}: later")), 1)
            self.assertEqual(messages("tests/a.cpp", f"int {word}S_;"), [])


class House(unittest.TestCase):
    def test_folders_that_include_each_other(self):
        there = {"models/a/x.hpp": '#include "models/b/y.hpp"\n', "models/b/y.hpp": "\n"}
        self.assertEqual(house.findings(there), [])
        back = {"models/b/z.cpp": '#include "models/c/w.hpp"\n', "models/c/w.hpp": '#include "models/a/x.hpp"\n'}
        found = house.findings(there | back)
        self.assertEqual(len(found), 3)
        self.assertIn("models/b/z.cpp:1: models/b includes models/c, which leads back to models/b", found[1])

    def test_tests_and_headers_that_are_not_there_are_no_circle(self):
        texts = {"models/a/x.hpp": '#include "generated/y.hpp"\n', "tests/x.cpp": '#include "tests/a/y.hpp"\n',
                 "tests/a/y.hpp": '#include "tests/x.cpp"\n'}
        self.assertEqual(house.findings(texts), [])

    def test_studies_beside_the_program(self):
        good = ["studies/CMakeLists.txt", "studies/dda/main.cpp", "studies/dam/README.md", "studies/dam/study.py"]
        self.assertEqual(house.findings(dict.fromkeys(good, "")), [])
        for bad in ("studies/tool.py", "studies/dam/fast.cpp", "studies/wall/deck.yaml"):
            self.assertEqual(len(house.findings(dict.fromkeys([*good, bad], ""))), 1, bad)


class Functions(unittest.TestCase):
    def test_parameters(self):
        for signature, number in (("()", 0), ("(int a)", 1), ("(std::map<int, int> a, F<void(int, int)> b) const", 2)):
            self.assertEqual(functions.num_parameters(signature), number, signature)

    def test_length_and_parameters(self):
        with tempfile.TemporaryDirectory() as folder:
            body = "".join(f"  a += {i};\n" for i in range(37))
            text = f"int just(int a, int b, int c, int d) {{\n{body}  return a;\n}}\n"
            long = f"int over(int a, int b, int c, int d, int e) {{\n{body}  ++a;\n  return a;\n}}\n"
            (Path(folder) / "models").mkdir()
            (Path(folder) / "models/a.cpp").write_text(text + long, encoding="utf-8")
            found = functions.findings(Path(folder), ["models/a.cpp"])
        self.assertEqual(found, ["models/a.cpp:41: over has 41 lines; a function has at most 40",
                                 "models/a.cpp:41: over has 5 parameters; a function has at most 4"])


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in rules.FOLDERS:
            self.write(f"{house.PROGRAM if name == 'studies' else name}/a.hpp", "#pragma once\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def run_main(self):
        with contextlib.redirect_stdout(io.StringIO()) as output:
            code = check.main(self.root)
        return code, output.getvalue()

    def test_a_clean_tree_passes(self):
        self.assertEqual(self.run_main(), (0, "5 files obey the rules\n"))

    def test_a_broken_file_deep_inside_fails_with_its_place(self):
        self.write("models/interface/law.cpp", '#include <map>\n#include "continuation/path/path.hpp"\n')
        code, output = self.run_main()
        self.assertEqual(code, 1)
        self.assertIn("models/interface/law.cpp:2: models must not include continuation/path/path.hpp", output)

    def test_the_python_package_is_read(self):
        self.write("python/ddapath/a.py", "# FIX" + "ME\n")
        code, output = self.run_main()
        self.assertEqual(code, 1)
        self.assertIn("python/ddapath/a.py:1:", output)

    def test_a_missing_folder_fails(self):
        (self.root / "models" / "a.hpp").unlink()
        (self.root / "models").rmdir()
        code, output = self.run_main()
        self.assertEqual(code, 1)
        self.assertIn("models: folder not found", output)

    def test_what_was_built_is_not_read(self):
        self.write("build/release/generated/a.cpp", '// FIX' + 'ME\n')
        self.assertEqual(self.run_main()[0], 0)


if __name__ == "__main__":
    unittest.main()
