// Which OSMesa context is current in which thread.
#pragma once

struct osmesa_context;

namespace terrazzo::osmesa {

// The calling thread's context, or null.
osmesa_context* current_context();

// Finishes and presents the picture of the calling thread's context, if it is another than `next`. Throws
// std::bad_alloc, and what was drawn waits.
void present_before(const osmesa_context* next);

// Makes `context`, or none, the calling thread's, after present_before().
void set_current(osmesa_context* context) noexcept;

// Frees the context: at once, or when the last thread that has it current lets go of it.
void destroy(osmesa_context* context);

}  // namespace terrazzo::osmesa
