// A short list of different sentences.
#include "notes.h"

#include <algorithm>

namespace terrazzo::gltf {
namespace {

constexpr std::size_t kMostSentences = 16;
constexpr std::size_t kLongestSentence = 300;  // files choose the names that sentences quote

// Names from files may hold what a terminal takes for commands.
std::string printable(std::string text) {
    if (text.size() > kLongestSentence) text = text.substr(0, kLongestSentence) + "...";
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

}  // namespace

void Notes::add(const std::string& sentence) {
    const std::string text = printable(sentence);
    if (text.empty() || std::find(m_sentences.begin(), m_sentences.end(), text) != m_sentences.end()) return;
    if (m_sentences.size() < kMostSentences) {
        m_sentences.push_back(text);
    } else {
        ++m_left_out;
    }
}

std::vector<std::string> Notes::sentences() const {
    std::vector<std::string> all = m_sentences;
    if (m_left_out > 0) all.push_back("and " + std::to_string(m_left_out) + " more like these");
    return all;
}

}  // namespace terrazzo::gltf
