// The contexts of an episode, each with what is known of it, and who has it.
// Invariant: a slot's context is used only by the thread that holds the slot.
#pragma once

#include <array>
#include <mutex>
#include <optional>
#include <utility>

#include "fuzz/session.h"

namespace terrazzo::fuzz {

// Slots 0 and 1 make a share group, 2 and 3 another, and so on.
inline constexpr unsigned kContexts = 6;

template <typename Handle>
struct ContextSlot {
    Handle handle{};
    ContextModel model;
    bool held = false;
};

template <typename Handle>
class ContextPool {
  public:
    // The slot if nobody has it; else null.
    ContextSlot<Handle>* take(unsigned index) {
        const std::lock_guard lock(m_mutex);
        ContextSlot<Handle>& slot = m_slots[index];
        if (slot.held) return nullptr;
        slot.held = true;
        return &slot;
    }
    void give_back(ContextSlot<Handle>* slot) {
        const std::lock_guard lock(m_mutex);
        if (slot) slot->held = false;
    }
    // The context with which the slot's shares objects; null where there is none or somebody uses it.
    Handle partner(unsigned index) {
        const std::lock_guard lock(m_mutex);
        return m_slots[index ^ 1].handle;
    }
    void set_handle(ContextSlot<Handle>& slot, Handle handle) {
        const std::lock_guard lock(m_mutex);
        slot.handle = handle;
    }
    std::array<ContextSlot<Handle>, kContexts>& slots() { return m_slots; }
    std::mutex& mutex() { return m_mutex; }

  private:
    std::mutex m_mutex;
    std::array<ContextSlot<Handle>, kContexts> m_slots;
};

}  // namespace terrazzo::fuzz
