// Ranges of object names; see name_ranges.h.
#include "gl/name_ranges.h"

#include <algorithm>
#include <iterator>

namespace terrazzo::gl {

bool NameRanges::contains(GLuint name) const {
    const auto after = m_last_of.upper_bound(name);
    return after != m_last_of.begin() && std::prev(after)->second >= name;
}

void NameRanges::insert(GLuint first, GLuint last) {
    auto next = m_last_of.upper_bound(first);
    if (next != m_last_of.begin() && std::prev(next)->second >= first - 1) {
        --next;
        first = next->first;
        last = std::max(last, next->second);
    }
    // The new range is in place before those it swallows go, so that lack of memory leaves the set as it was.
    const auto range = m_last_of.insert_or_assign(first, last).first;
    auto swallowed = std::next(range);
    while (swallowed != m_last_of.end() && swallowed->first - 1 <= range->second) {
        range->second = std::max(range->second, swallowed->second);
        swallowed = m_last_of.erase(swallowed);
    }
}

void NameRanges::erase(GLuint first, GLuint last) {
    // A range that goes on behind `last` is cut there first: nothing else needs memory.
    if (const auto after = m_last_of.upper_bound(last); after != m_last_of.begin()) {
        const auto cut = std::prev(after);
        if (cut->second > last) {
            m_last_of.emplace_hint(after, last + 1, cut->second);
            cut->second = last;
        }
    }
    auto range = m_last_of.upper_bound(first);
    if (range != m_last_of.begin() && std::prev(range)->second >= first) --range;
    while (range != m_last_of.end() && range->first <= last) {
        if (range->first < first) {
            range->second = first - 1;
            ++range;
        } else {
            range = m_last_of.erase(range);
        }
    }
}

GLuint NameRanges::take(GLuint count) {
    if (count == 0) return 0;
    GLuint first = 1;
    for (const auto& [range_first, range_last] : m_last_of) {
        if (range_first - first >= count) break;
        first = range_last + 1;
        if (first == 0) return 0;  // the highest name of all is in use
    }
    if (count - 1 > ~first) return 0;
    insert(first, first + (count - 1));
    return first;
}

}  // namespace terrazzo::gl
