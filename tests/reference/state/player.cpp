// The player's choices, and the list of all chapters' commands; see player.h.
#include "player.h"

#include <iterator>

#include "commands.h"

namespace terrazzo::test {
namespace {

// Enumerants that no command of the player takes, in any version of GL.
const Enumerants kInvalid = {TERRAZZO_E(GL_TRIANGLE_FAN), TERRAZZO_E(GL_2_BYTES),
                             TERRAZZO_E(GL_VENDOR),       TERRAZZO_E(GL_FEEDBACK),
                             {0x1234, "0x1234"},          {0xffffffffu, "0xffffffff"}};

std::vector<Command> all_commands() {
    std::vector<Command> commands;
    for (const auto chapter :
         {transformation_commands(), lighting_commands(), rasterization_commands(), texturing_commands(),
          fragments_commands(), vertices_commands(), pixels_commands(), modes_commands()})
        commands.insert(commands.end(), chapter.begin(), chapter.end());
    return commands;
}

}  // namespace

std::string StatePlayer::play() {
    static const std::vector<Command> commands = all_commands();
    const Command& command = commands[pick(static_cast<unsigned>(commands.size()))];
    m_text = command.name;
    command.play(*this);
    return m_text;
}

GLenum StatePlayer::enumerant(const std::vector<Enumerant>& valid) {
    const auto& source = pick(12) == 0 ? kInvalid : valid;
    const Enumerant& chosen = source[pick(static_cast<unsigned>(source.size()))];
    note(chosen.name);
    return chosen.value;
}

GLfloat StatePlayer::number() {
    if (pick(16)) return moderate_number();
    note("1e10");
    return 1e10f;
}

GLfloat StatePlayer::moderate_number() {
    constexpr GLfloat kSpecial[] = {0, 1, -1, 0.5f, 2, 90, 128, 255, 1e-5f, -300};
    const bool special = pick(2) == 0;
    const GLfloat value =
        special ? kSpecial[pick(std::size(kSpecial))] : static_cast<GLfloat>(pick(20001)) / 4096.0f - 2.0f;
    note(std::to_string(value));
    return value;
}

GLint StatePlayer::integer() {
    constexpr GLint kSpecial[] = {0, 1, -1, 2, 255, 256, 257, 16384, 16385, 2147483647, -2147483647 - 1};
    const GLint value = pick(2) ? kSpecial[pick(std::size(kSpecial))] : static_cast<GLint>(pick(600)) - 100;
    note(std::to_string(value));
    return value;
}

std::vector<GLfloat> StatePlayer::numbers(int count) {
    std::vector<GLfloat> values;
    for (int i = 0; i < count; ++i) values.push_back(number());
    return values;
}

std::vector<GLfloat> StatePlayer::moderate_numbers(int count) {
    std::vector<GLfloat> values;
    for (int i = 0; i < count; ++i) values.push_back(moderate_number());
    return values;
}

void StatePlayer::note(const std::string& argument) {
    m_text += ' ' + argument;
}

}  // namespace terrazzo::test
