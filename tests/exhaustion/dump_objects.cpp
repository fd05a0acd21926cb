// The state, and what objects hold: names in use, images of bound textures, buffers, attachments, maps.
#include <cstdio>

#include "exhaust.h"
#include "state_dump.h"

namespace terrazzo::test {
namespace {

constexpr GLuint kMostNames = 8;

class ObjectDump {
  public:
    ObjectDump(const kit::Gl& gl, std::vector<std::string>& lines) : m_gl(gl), m_lines(lines) {}

    void names() {
        for (GLuint name = 1; name <= kMostNames; ++name) {
            const unsigned used = unsigned{m_gl.IsTexture(name)} | unsigned{m_gl.IsList(name)} << 1 |
                                  unsigned{m_gl.IsBuffer(name)} << 2 | unsigned{m_gl.IsQuery(name)} << 3 |
                                  unsigned{m_gl.IsFramebuffer(name)} << 4 |
                                  unsigned{m_gl.IsRenderbuffer(name)} << 5;
            add("name " + std::to_string(name), used);
        }
    }

    void textures() {
        m_gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
        m_gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        for (const GLenum parameter : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                                       GL_PACK_SKIP_IMAGES, GL_PACK_IMAGE_HEIGHT})
            m_gl.PixelStorei(parameter, 0);
        for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D}) images(target);
        for (GLenum face = 0; face < 6; ++face) images(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
        m_gl.PopClientAttrib();
    }

    void attachments() {
        for (const GLenum target : {GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER}) {
            GLint bound = 0;
            m_gl.GetIntegerv(
                target == GL_DRAW_FRAMEBUFFER ? GL_DRAW_FRAMEBUFFER_BINDING : GL_READ_FRAMEBUFFER_BINDING,
                &bound);
            add("frame buffer", static_cast<unsigned>(bound));
            if (bound == 0) continue;
            for (const GLenum point : {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT}) {
                GLint type = 0, name = 0;
                m_gl.GetFramebufferAttachmentParameteriv(target, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
                                                         &type);
                if (type != GL_NONE)
                    m_gl.GetFramebufferAttachmentParameteriv(target, point,
                                                             GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
                add("attachment " + std::to_string(type), static_cast<unsigned>(name));
            }
        }
        GLint bound = 0;
        m_gl.GetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
        add("renderbuffer", static_cast<unsigned>(bound));
        for (const GLenum pname : {GL_RENDERBUFFER_WIDTH, GL_RENDERBUFFER_HEIGHT, GL_RENDERBUFFER_SAMPLES,
                                   GL_RENDERBUFFER_INTERNAL_FORMAT, GL_RENDERBUFFER_DEPTH_SIZE}) {
            GLint value = 0;
            if (bound != 0) m_gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, pname, &value);
            add("renderbuffer's", static_cast<unsigned>(value));
        }
    }

    void maps() {
        for (const GLenum map : {GL_MAP1_VERTEX_3, GL_MAP2_VERTEX_3, GL_MAP2_NORMAL, GL_MAP1_COLOR_4}) {
            GLfloat values[30 * 4] = {};
            m_gl.GetMapfv(map, GL_COEFF, values);
            add("map", hash(values, sizeof values));
        }
        for (const GLenum map : {GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_I_TO_A, GL_PIXEL_MAP_S_TO_S}) {
            GLfloat values[256] = {};
            m_gl.GetPixelMapfv(map, values);
            add("pixel map", hash(values, sizeof values));
        }
    }

    void lists() {
        for (const GLenum pname : {GL_LIST_INDEX, GL_LIST_MODE, GL_RENDER_MODE, GL_NAME_STACK_DEPTH,
                                   GL_ATTRIB_STACK_DEPTH, GL_CLIENT_ATTRIB_STACK_DEPTH}) {
            GLint value = 0;
            m_gl.GetIntegerv(pname, &value);
            add("list and stacks", static_cast<unsigned>(value));
        }
        add("error after the objects", m_gl.GetError());
    }

  private:
    void add(const std::string& what, unsigned value) {
        m_lines.push_back(what + ' ' + std::to_string(value));
    }

    static unsigned hash(const void* from, std::size_t size) {
        unsigned value = 2166136261u;
        for (const auto* byte = static_cast<const unsigned char*>(from); size > 0; --size, ++byte)
            value = (value ^ *byte) * 16777619u;
        return value;
    }

    void images(GLenum target) {
        for (GLint level = 0; level < 7; ++level) {
            GLint sizes[3] = {}, format = 0, compressed = 0, has_depth = 0;
            m_gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &sizes[0]);
            m_gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_HEIGHT, &sizes[1]);
            m_gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_DEPTH, &sizes[2]);
            m_gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_INTERNAL_FORMAT, &format);
            m_gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_COMPRESSED, &compressed);
            m_gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_DEPTH_SIZE, &has_depth);
            std::vector<GLfloat> texels(static_cast<std::size_t>(sizes[0]) *
                                        static_cast<std::size_t>(sizes[1]) *
                                        static_cast<std::size_t>(sizes[2]) * 4);
            if (!texels.empty())
                m_gl.GetTexImage(target, level, has_depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT,
                                 texels.data());
            char text[128];
            std::snprintf(text, sizeof text, "image %x.%d: %dx%dx%d %x %d", target, level, sizes[0], sizes[1],
                          sizes[2], static_cast<unsigned>(format), compressed);
            add(text, hash(texels.data(), texels.size() * sizeof texels[0]));
        }
    }

    const kit::Gl& m_gl;
    std::vector<std::string>& m_lines;
};

}  // namespace

std::vector<std::string> dump_with_objects(const kit::Gl& gl) {
    std::vector<std::string> lines = dump_state(gl);
    ObjectDump dump(gl, lines);
    dump.names();
    dump.textures();
    dump.attachments();
    dump.maps();
    dump.lists();
    return lines;
}

}  // namespace terrazzo::test
