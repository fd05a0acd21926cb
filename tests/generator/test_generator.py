"""What the generator of entry points makes of the registry and of policies, good and bad."""

import pathlib
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path.insert(0, str(TOOLS))

from generator import dispatch, forms, fuzz_table, lists  # noqa: E402
from generator.policy import Policy, PolicyError  # noqa: E402
from generator.registry import Registry  # noqa: E402

REGISTRY = Registry("/usr/share/khronos-api/gl.xml")
EXPORTS = (TOOLS / "osmesa-exports.txt").read_text().split()


def policy_of(core, forms_text="", rules="", extensions=()):
    text = (f'[core.test]\n{core}\n[forms]\n{forms_text}\n[parameters.Fog]\nGL_FOG_COLOR = "4 normalised"\n[aliases]\n'
            f'[extensions]\noffered = {list(extensions)}\n[rules]\n')
    text += rules or 'inside_begin_end = ["glVertex.*"]\nnot_in_lists = ["glGet.*"]\nmay_be_null = []\n'
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text)
        file.flush()
        return Policy(file.name, REGISTRY, EXPORTS)


def thunk_of(policy, name):
    return forms.thunk(policy, next(m for m in policy.members if m.command.name == name))


class Names(unittest.TestCase):
    def test_snake_case(self):
        for name, snake in {"glTexImage2D": "tex_image_2d", "glTexParameterfv": "tex_parameterfv",
                            "glVertex4f": "vertex4f", "glGetTexLevelParameteriv": "get_tex_level_parameteriv",
                            "glCopyTexSubImage1D": "copy_tex_sub_image_1d"}.items():
            self.assertEqual(REGISTRY.commands[name].snake, snake)

    def test_types(self):
        self.assertEqual([p.type for p in REGISTRY.commands["glMultiDrawElements"].parameters],
                         ["GLenum", "const GLsizei*", "GLenum", "const void*const*", "GLsizei"])
        self.assertEqual(REGISTRY.commands["glGetString"].result, "const GLubyte*")


class Coverage(unittest.TestCase):
    def test_every_command_up_to_1_5_is_exported(self):
        names = [n for number in ("1.0", "1.1", "1.2", "1.3", "1.4", "1.5") for n in REGISTRY.versions[number]]
        self.assertEqual(len(names), 452)
        self.assertLessEqual(set(names), set(EXPORTS))

    def test_the_project_s_policy_is_accepted_and_its_output_depends_on_nothing_else(self):
        def generate():
            policy = Policy(TOOLS / "policy.toml", REGISTRY, EXPORTS)
            return dispatch.outputs(policy) | lists.outputs(policy)
        first = generate()
        self.assertEqual(first, generate())
        for name in EXPORTS:
            if name.startswith("gl"):
                self.assertEqual(first["entries.cpp"].count(f" {name}("), 1, name)

    def test_every_argument_form_is_made_from_its_core(self):
        """Each command of 1.0 that ends in a type is core or has a form, once all core commands exist."""
        text = (TOOLS / "policy.toml").read_text().replace("\n# gl", "\ngl")
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write(text)
            file.flush()
            policy = Policy(file.name, REGISTRY, EXPORTS)
        vertex_commands = [n for n in REGISTRY.versions["1.0"] if policy.matches("inside_begin_end", n)
                           and not n.startswith(("glEval", "glArray"))]
        self.assertEqual([n for n in vertex_commands if n not in policy.names], [])

    def test_the_version_never_promises_more_than_there_is(self):
        self.assertEqual(policy_of("glFlush = {}").gl_version(), "1.0")
        one_one = REGISTRY.versions["1.0"] + REGISTRY.versions["1.1"]
        self.assertEqual(policy_of("".join(f"{n} = {{}}\n" for n in one_one)).gl_version(), "1.1")
        self.assertEqual(policy_of("".join(f"{n} = {{}}\n" for n in one_one[1:])).gl_version(), "1.0")


    def test_an_extension_is_offered_only_with_all_its_commands(self):
        self.assertEqual(policy_of("glFlush = {}").gl_extensions(), "")
        offered = ["GL_EXT_blend_color", "GL_EXT_abgr"]
        self.assertEqual(policy_of("glBlendColor = {}", extensions=offered).gl_extensions(),
                         "GL_EXT_abgr GL_EXT_blend_color")
        with self.assertRaisesRegex(PolicyError, "GL_EXT_blend_color is offered without glBlendColorEXT"):
            policy_of("glFlush = {}", extensions=offered).gl_extensions()
        with self.assertRaisesRegex(PolicyError, "GL_EXT_nothing is not an extension"):
            policy_of("glFlush = {}", extensions=["GL_EXT_nothing"]).gl_extensions()


class Forms(unittest.TestCase):
    POLICY = policy_of(
        "glVertex4f = {}\nglColor4f = {}\nglRectf = {}\nglFogfv = {}\nglLoadMatrixf = {}\nglPixelStorei = {}",
        """components.glVertex4f = { from = "glVertex[234][dfis]v?", pad = [0, 0, 0, 1] }
components.glColor4f = { from = "glColor3ubv?", pad = [0, 0, 0, 1], normalised = true }
components.glRectf = { from = "glRectdv" }
values.glFogfv = { from = "glFog(f|iv)", values = "Fog" }
matrix.glLoadMatrixf = { from = "glLoadTransposeMatrixf" }
forward.glPixelStorei = { from = "glPixelStoref" }""")

    def test_components_are_converted_and_padded(self):
        self.assertIn("Do::Vertex4f(*ctx, static_cast<GLfloat>(x), static_cast<GLfloat>(y), GLfloat(0), GLfloat(1));",
                      thunk_of(self.POLICY, "glVertex2i"))
        self.assertIn("Do::Vertex4f(*ctx, v[0], v[1], v[2], GLfloat(1));", thunk_of(self.POLICY, "glVertex3fv"))

    def test_colours_are_normalised(self):
        self.assertIn("normalised(v[2]), GLfloat(1)", thunk_of(self.POLICY, "glColor3ubv"))

    def test_several_vectors(self):
        self.assertIn("(v1[1]), static_cast<GLfloat>(v2[0])", thunk_of(self.POLICY, "glRectdv"))

    def test_null_is_refused(self):
        self.assertIn("if (!v1) [[unlikely]]", thunk_of(self.POLICY, "glRectdv"))
        self.assertIn('GL_INVALID_VALUE, "params is null"', thunk_of(self.POLICY, "glFogfv"))

    def test_a_single_value_is_the_first_of_a_vector(self):
        self.assertIn("const GLfloat vector[4] = {param};", thunk_of(self.POLICY, "glFogf"))
        self.assertNotIn("kRecords", thunk_of(self.POLICY, "glFogf"))

    def test_a_single_value_is_refused_for_a_vector_outside_lists(self):
        policy = policy_of("glFogfv = {}", 'values.glFogfv = { from = "glFogf", values = "Fog", refuses = true }')
        self.assertIn("if (!Do::kRecords && fog_count(pname).size > 1)", thunk_of(policy, "glFogf"))

    def test_transposition(self):
        self.assertIn("{m[0], m[4], m[8], m[12], m[1],", thunk_of(self.POLICY, "glLoadTransposeMatrixf"))

    def test_counts_that_are_left_out_are_checked(self):
        policy = policy_of("glVertexPointer = {}", 'forward.glVertexPointer = { from = "glVertexPointerEXT" }')
        self.assertIn('if (count < 0) return Do::error(*ctx, Allowed::kAnywhere, GL_INVALID_VALUE, "count is negative");',
                      thunk_of(policy, "glVertexPointerEXT"))

    def test_floats_given_for_integers_are_rounded(self):
        self.assertIn("Do::PixelStorei(*ctx, pname, rounded(param));", thunk_of(self.POLICY, "glPixelStoref"))


class Targets(unittest.TestCase):
    def test_aliases_lead_to_the_command(self):
        policy = policy_of("glBlendColor = {}")
        self.assertEqual(policy.target("glBlendColorEXT"), "glBlendColor")
        self.assertIn("current.table->BlendColor(current.context, red, green, blue, alpha)",
                      dispatch.entry(policy, "glBlendColorEXT"))

    def test_what_is_missing_says_so(self):
        policy = policy_of("glFlush = {}")
        self.assertIsNone(policy.target("glFinish"))
        self.assertIn('not_implemented("glFinish")', dispatch.entry(policy, "glFinish"))
        self.assertNotIn('"glFinish", reinterpret_cast', dispatch.entries_source(policy))


class Mistakes(unittest.TestCase):
    def test_are_found(self):
        with self.assertRaisesRegex(PolicyError, "glNoSuchCommand"):
            policy_of("glNoSuchCommand = {}")
        with self.assertRaisesRegex(PolicyError, "no exported command matches"):
            policy_of("glVertex4f = {}", 'components.glVertex4f = { from = "glVertices" }')
        with self.assertRaisesRegex(PolicyError, "more values"):
            policy = policy_of("glVertex2f = {}", 'components.glVertex2f = { from = "glVertex3f" }')
            thunk_of(policy, "glVertex3f")


class FuzzTable(unittest.TestCase):
    def setUp(self):
        self.policy = Policy(TOOLS / "policy.toml", REGISTRY, EXPORTS)
        self.lines = fuzz_table.outputs(self.policy)["fuzz_table.cpp"].splitlines()

    def line(self, start):
        found = [line for line in self.lines if line.strip().startswith(start)]
        self.assertEqual(len(found), 1, start)
        return found[0]

    def test_has_every_exported_command_with_the_registry_s_signature(self):
        for name in self.policy.known_exports():
            self.line(f'{{"{name}", ')
        self.assertIn("&invoke<void, GLenum, GLint, GLint, GLsizei, GLint, GLenum, GLenum, const void*>",
                      self.line('{"glTexImage1D", '))

    def test_a_form_names_its_family_and_what_is_missing_has_none(self):
        self.assertIn('{"glVertex2sv", "glVertex4f", ', self.line('{"glVertex2sv"'))
        self.assertIn('{"glAttachShader", "", ', self.line('{"glAttachShader"'))

    def test_parameters_have_their_type_direction_class_and_length(self):
        self.assertIn('{"textures", \'u\', true, true, -1, ObjectClass::kTexture, "n"}',
                      self.line("constexpr Parameter kParametersOf_glGenTextures[]"))
        self.assertIn('"COMPSIZE(pname)"', self.line("constexpr Parameter kParametersOf_glFogfv[]"))

    def test_a_group_begins_with_what_is_offered(self):
        values = self.line("constexpr Enumerant kStencilOp[]")
        self.assertIn("GL_KEEP", values)
        group = self.line('{"TextureParameterName", kTextureParameterName, ')
        offered = int(group.rstrip("},").split(", ")[-1])
        names = self.line("constexpr Enumerant kTextureParameterName[]").split("}, {")
        self.assertIn("GL_TEXTURE_MIN_FILTER", "".join(names[:offered]))
        self.assertIn("GL_TEXTURE_SWIZZLE_R", "".join(names[offered:]))


if __name__ == "__main__":
    unittest.main()
