// Handles that a window system gave out, living and dead, and others that it never gave out.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "fuzz/session.h"

namespace terrazzo::fuzz {

// Of one kind; threads share it.
template <typename Handle>
class Handles {
  public:
    void add(Handle handle) {
        const std::lock_guard lock(m_mutex);
        if (handle) m_all.push_back(handle);
    }
    // One of the last, mostly; else one of all, or none.
    Handle draw(Random& random) const {
        const std::lock_guard lock(m_mutex);
        const unsigned choice = random.below(24), which = random.below(1u << 16);
        const auto count = static_cast<unsigned>(m_all.size());
        if (count == 0 || choice == 0) return Handle{};
        const unsigned recent = choice < 20 && count > 6 ? 6 : count;
        return m_all[count - 1 - which % recent];
    }
    std::size_t size() const {
        const std::lock_guard lock(m_mutex);
        return m_all.size();
    }

  private:
    mutable std::mutex m_mutex;
    std::vector<Handle> m_all;
};

// What is known of each context, by its handle. A handle may come again; what is known of the old one stays,
// for it may still be current somewhere.
template <typename Handle>
class Models {
  public:
    void make(Handle handle) {
        const std::lock_guard lock(m_mutex);
        m_by_handle[handle] = m_all.emplace_back(std::make_unique<ContextModel>()).get();
    }
    ContextModel* find(Handle handle) {
        const std::lock_guard lock(m_mutex);
        const auto found = m_by_handle.find(handle);
        return found == m_by_handle.end() ? nullptr : found->second;
    }

  private:
    std::mutex m_mutex;
    std::vector<std::unique_ptr<ContextModel>> m_all;
    std::map<Handle, ContextModel*> m_by_handle;
};

}  // namespace terrazzo::fuzz
