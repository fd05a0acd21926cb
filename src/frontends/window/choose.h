// How GLX and EGL choose among configurations: both specify a table of attributes, each with a way to compare
// the value that a program asks for and a way to sort those that fit (GLX 1.4 table 3.4, EGL 1.5 table 3.4).
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace terrazzo::window {

enum class Match { kExact, kAtLeast, kMask, kIgnored };
// Totals: the bits of all components together that the program asked for.
enum class Order { kNone, kSmaller, kLarger, kColorTotal, kAccumTotal };

inline constexpr int kDontCare = -1;  // GLX_DONT_CARE, EGL_DONT_CARE: every value fits

template <class Config>
struct Attribute {
    int name;
    Match match;
    Order order;
    int standard;  // when the program does not name it
    int (*value)(const Config&);
};

using Wishes = std::map<int, int>;  // attribute to value

// `attributes` in the order in which configurations are compared.
template <class Config>
class Chooser {
  public:
    constexpr explicit Chooser(std::span<const Attribute<Config>> attributes) : m_attributes(attributes) {}

    const Attribute<Config>* find(int name) const {
        const auto found = std::ranges::find(m_attributes, name, &Attribute<Config>::name);
        return found == m_attributes.end() ? nullptr : &*found;
    }

    std::optional<int> value(const Config& config, int name) const {
        const Attribute<Config>* attribute = find(name);
        return attribute ? std::optional(attribute->value(config)) : std::nullopt;
    }

    // Those that fit, best first. A wish for `id_name` says everything: others are ignored then.
    std::vector<const Config*> choose(const std::vector<Config>& configs, const Wishes& wishes,
                                      int id_name) const {
        const auto id = wishes.find(id_name);
        const bool by_id = id != wishes.end() && id->second != kDontCare;
        std::vector<const Config*> out;
        for (const Config& config : configs) {
            if (by_id ? find(id_name)->value(config) == id->second : fits(config, wishes))
                out.push_back(&config);
        }
        std::ranges::stable_sort(
            out, [&](const Config* a, const Config* b) { return compare(*a, *b, wishes) < 0; });
        return out;
    }

  private:
    static int wish(const Wishes& wishes, const Attribute<Config>& attribute) {
        const auto found = wishes.find(attribute.name);
        return found == wishes.end() ? attribute.standard : found->second;
    }

    bool fits(const Config& config, const Wishes& wishes) const {
        return std::ranges::all_of(m_attributes, [&](const Attribute<Config>& attribute) {
            const int wanted = wish(wishes, attribute);
            if (wanted == kDontCare) return true;
            const int has = attribute.value(config);
            switch (attribute.match) {
                case Match::kExact:
                    return has == wanted;
                case Match::kAtLeast:
                    return has >= wanted;
                case Match::kMask:
                    return (has & wanted) == wanted;
                case Match::kIgnored:
                    return true;
            }
            return false;
        });
    }

    int total(const Config& config, const Wishes& wishes, Order order) const {
        int sum = 0;
        for (const Attribute<Config>& attribute : m_attributes) {
            if (attribute.order == order && wish(wishes, attribute) > 0) sum += attribute.value(config);
        }
        return sum;
    }

    // Negative when `a` comes first.
    int compare(const Config& a, const Config& b, const Wishes& wishes) const {
        for (const Attribute<Config>& attribute : m_attributes) {
            int difference = 0;
            switch (attribute.order) {
                case Order::kNone:
                    break;
                case Order::kSmaller:
                    difference = attribute.value(a) - attribute.value(b);
                    break;
                case Order::kLarger:
                    difference = attribute.value(b) - attribute.value(a);
                    break;
                case Order::kColorTotal:
                case Order::kAccumTotal:  // the same for each of the components
                    difference = total(b, wishes, attribute.order) - total(a, wishes, attribute.order);
            }
            if (difference != 0) return difference;
        }
        return 0;
    }

    std::span<const Attribute<Config>> m_attributes;
};

}  // namespace terrazzo::window
