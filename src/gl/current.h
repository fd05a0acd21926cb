// The calling thread's context and the dispatch table its GL calls go through.
//
// An exported function is one TLS load and one indirect call: `current.table->Foo(current.context, ...)`. The
// table stands for the state the context is in (no context, normal, between Begin and End, compiling a list),
// so commands do not test for it. Invariant: `table` is never null; `context` is null exactly when no context
// is current.
#pragma once

namespace terrazzo::gl {

struct Context;
struct Dispatch;

struct CurrentContext {
    const Dispatch* table;
    Context* context;
};

// initial-exec: one load from the thread pointer, also in a library that was loaded at run time.
extern constinit thread_local CurrentContext current
    __attribute__((tls_model("initial-exec"), visibility("hidden")));

extern const Dispatch kNormalTable;
extern const Dispatch kInsideBeginEndTable;
extern const Dispatch kCompilingTable;
extern const Dispatch kNoContextTable;

// Makes `ctx` the calling thread's context; null releases. The front end has made sure that no other thread
// uses it.
void make_current(Context* ctx);

}  // namespace terrazzo::gl
