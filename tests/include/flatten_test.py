"""Tests of tools/flatten, and of what it makes of our sources."""
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(os.environ["CLEAVE_SOURCE"])
GENERATED = pathlib.Path(os.environ["CLEAVE_GLSL"], "cleave.glsl")


def flatten_module():
    loader = importlib.machinery.SourceFileLoader("flatten", str(SOURCE / "tools/flatten"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("flatten", loader))
    loader.exec_module(module)
    return module


flatten = flatten_module()


def flattened(files, lists=("list.glsl",)):
    """The texts made of files (name: text); the first list includes first.h unless it is among them."""
    with tempfile.TemporaryDirectory() as folder:
        shaders = pathlib.Path(folder)
        files = {"list.glsl": '#ifndef LIST\n#define LIST\n#include "first.h"\n#endif\n'} | files
        for name, text in files.items():
            (shaders / name).write_text(text)
        texts = flatten.flatten(shaders, [shaders / name for name in lists])
        return [texts[name] for name in lists]


def guarded(body, guard="FIRST_H", heading="// Heading.\n"):
    return f"{heading}#ifndef {guard}\n#define {guard}\n{body}\n#endif\n"


def of(body):
    """What becomes of one file with this body."""
    return flattened({"first.h": guarded(body)})[0]


class Names(unittest.TestCase):
    def test_prefixes_types_functions_constants_and_blocks(self):
        text = of("struct Box { float size; };\nconst uint kMost = 3u;\n"
                  "layout(buffer_reference, scalar) buffer Boxes { Box at[kMost]; };\n"
                  "Box first(Boxes boxes) { return boxes.at[kMost - 1u]; }")
        self.assertIn("struct CleaveBox { float size; };", text)
        self.assertIn("const uint kCleaveMost = 3u;", text)
        self.assertIn("buffer CleaveBoxes { CleaveBox at[kCleaveMost]; };", text)
        self.assertIn("CleaveBox cleaveFirst(CleaveBoxes boxes) { return boxes.at[kCleaveMost - 1u]; }", text)

    def test_leaves_members_alone_that_are_named_like_functions(self):
        text = of("float size(float x) { return x; }\nstruct Box { float size; };\n"
                  "float twice(Box b) { return size(b.size) + size(b . size); }")
        self.assertIn("struct CleaveBox { float size; };", text)
        self.assertIn("return cleaveSize(b.size) + cleaveSize(b . size);", text)

    def test_leaves_builtins_and_locals_alone(self):
        text = of("float least(vec3 v) { precise float low = min(v.x, 1.0e-3f); return abs(low); }")
        self.assertIn("float cleaveLeast(vec3 v) { precise float low = min(v.x, 1.0e-3f); return abs(low); }", text)

    def test_names_in_comments_follow_words_do_not(self):
        text = of("// Returns the box; see isEmpty and box().\nbool isEmpty(int x) { return x == 0; }\n"
                  "bool box(int x) { return isEmpty(x); }  // A box.")
        self.assertIn("// Returns the box; see cleaveIsEmpty and cleaveBox().", text)
        self.assertIn("}  // A box.", text)

    def test_refuses_a_new_name_that_is_there_already(self):
        with self.assertRaisesRegex(flatten.Refused, "box would become cleaveBox, which is there already"):
            of("int box(int cleaveBox) { return cleaveBox; }")


class Files(unittest.TestCase):
    def test_includes_a_file_once_where_it_is_first_needed(self):
        first = guarded('#include "second.h"\n#include "second.h"\nint b() { return a(); }')
        text = flattened({"first.h": first, "second.h": guarded("int a() { return 1; }", "SECOND_H")})[0]
        self.assertEqual(text.count("int cleaveA()"), 1)
        self.assertLess(text.index("int cleaveA()"), text.index("int cleaveB()"))
        self.assertNotIn("#include", text)

    def test_keeps_of_files_that_are_not_listed_what_is_used(self):
        first = guarded('#include "second.h"\nint top() { return used(); }')
        second = guarded("int unused() { return 0; }\nint deep() { return 2; }\nint used() { return deep(); }",
                         "SECOND_H")
        text = flattened({"first.h": first, "second.h": second})[0]
        self.assertIn("int cleaveDeep()", text)
        self.assertIn("int cleaveUsed()", text)
        self.assertNotIn("nused", text)

    def test_a_second_list_adds_only_what_the_first_lacks(self):
        more = '#ifndef MORE\n#define MORE\n#include "second.h"\n#endif\n'
        second = guarded('#include "first.h"\nint b() { return a(); }', "SECOND_H")
        files = {"first.h": guarded("int a() { return 1; }"), "second.h": second, "more.glsl": more}
        one, two = flattened(files, ("list.glsl", "more.glsl"))
        self.assertIn("int cleaveA() { return 1; }", one)
        self.assertNotIn("int cleaveA()", two)
        self.assertIn("int cleaveB() { return cleaveA(); }", two)

    def test_drops_what_is_for_cpp(self):
        text = of("#ifdef __cplusplus\n#include <cmath>\nint no;\n#else\nint a() { return 1; }\n#endif\n"
                  "int b() {\n#ifdef __cplusplus\n    return 2;\n#endif\n    return 3;\n}")
        self.assertNotIn("cmath", text)
        self.assertNotIn("return 2", text)
        self.assertIn("int cleaveA() { return 1; }", text)
        self.assertRegex(text, r"int cleaveB\(\) \{\n\s+return 3;\n\}")

    def test_expands_macros(self):
        text = of("#define BEGIN\n#define FN\n"
                  "#define ARRAY(Name, Type) \\\n    layout(scalar) buffer Name { Type at[]; }\n"
                  "#define ADDRESS(Type) Type\nBEGIN\nFN int a(ADDRESS(int) x) { return x; }\nARRAY(Ints, int);")
        self.assertIn("\nint cleaveA(int x) { return x; }", text)
        self.assertIn("layout(scalar) buffer CleaveInts { int at[]; };", text)
        self.assertNotIn("#define B", text)

    def test_keeps_defaults_that_users_may_replace(self):
        text = of("const uint kOne = 1u;\n\n// How many.\n#ifndef CLEAVE_MANY\n#define CLEAVE_MANY kOne\n#endif\n"
                  "uint many() { return CLEAVE_MANY; }")
        self.assertIn("\n\n// How many.\n#ifndef CLEAVE_MANY\n#define CLEAVE_MANY kCleaveOne\n#endif\n", text)
        self.assertIn("uint cleaveMany() { return CLEAVE_MANY; }", text)


class Refusals(unittest.TestCase):
    def refuses(self, body, message):
        with self.assertRaisesRegex(flatten.Refused, message):
            of(body)

    def test_refuses_what_it_does_not_understand(self):
        self.refuses("#pragma once", r"first\.h:4: does not understand #pragma once")
        self.refuses("#if 1\n#endif", "does not understand #if 1")
        self.refuses("#extension GL_EXT_shader_atomic_float : require", "does not understand #extension")
        self.refuses("#ifndef MANY\n#define MANY 1\n#endif", "MANY does not begin with CLEAVE_")
        self.refuses("#undef kOne", "does not understand #undef kOne")
        self.refuses('#include "absent.h"', "absent.h, which is not there")
        self.refuses("#ifndef __cplusplus", "an #if without #endif")
        self.refuses("/* a */ int a() { return 1; }", "cannot read '/")
        self.refuses("uniform int a;", "does not understand the declaration uniform int a")
        self.refuses("int a() { return 1;", "ends within a declaration: int a")

    def test_refuses_a_file_without_a_guard(self):
        with self.assertRaisesRegex(flatten.Refused, "include guard"):
            flattened({"first.h": "int a() { return 1; }\n"})

    def test_refuses_other_lines_in_a_list(self):
        with self.assertRaisesRegex(flatten.Refused, "list.glsl:1: does not understand int a;"):
            flattened({"list.glsl": "int a;\n"})

    def test_the_program_says_so_and_fails(self):
        done = subprocess.run([SOURCE / "tools/flatten", SOURCE / "shaders", "/nonexistent", SOURCE / "README.md"],
                              capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^flatten: .*README\.md:1: does not understand")


class Generated(unittest.TestCase):
    def test_every_global_name_has_the_prefix(self):
        text = re.sub(r"//[^\n]*", "", GENERATED.read_text())
        depth, outside = 0, ""
        for c in text:  # what is outside of all braces and parentheses
            depth += c in "({"
            outside += c if depth == 0 else " "
            depth -= c in ")}"
        keywords = {"struct", "const", "layout", "buffer", "bool", "int", "uint", "float", "double", "void", "vec3",
                    "dvec3", "false", "true", "require"}
        lines = [line for line in outside.split("\n") if not line.startswith("#extension")]
        words = set(re.findall(r"(?<![\w.])[A-Za-z_]\w*", "\n".join(lines))) - keywords
        words -= {"ifndef", "define", "endif"}
        self.assertGreater(len(words), 50)
        self.assertEqual([w for w in sorted(words) if not re.match(r"(k?C|c)leave[A-Z]|CLEAVE_", w)], [])

    def test_nothing_of_ours_is_left(self):
        text = GENERATED.read_text()
        for word in ("#include", "__cplusplus", "CLEAVE_FN", "CLEAVE_CONST", "CLEAVE_SIZE", "gl_", "subgroup"):
            self.assertNotIn(word, re.sub(r"(?m)^//.*", "", text), word)

    def test_the_example_in_its_first_comment_compiles(self):
        example = "".join(re.findall(r"(?m)^//     (.*\n)", GENERATED.read_text().split("#ifndef")[0]))
        self.assertIn("cleaveTrace(", example)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "example.frag")
            path.write_text(example)
            done = subprocess.run([os.environ["GLSLANG"], "--target-env", "vulkan1.3", f"-I{GENERATED.parent}", "-o",
                                   f"{folder}/example.spv", path], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
