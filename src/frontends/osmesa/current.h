// Which OSMesa context is current in which thread.
#pragma once

struct osmesa_context;

namespace terrazzo::osmesa {

// The calling thread's context, or null.
osmesa_context* current_context();

// Makes `context`, or none, the calling thread's. The picture of the one it takes over from is finished and
// presented.
void set_current(osmesa_context* context);

// Frees the context: at once, or when the last thread that has it current lets go of it.
void destroy(osmesa_context* context);

}  // namespace terrazzo::osmesa
