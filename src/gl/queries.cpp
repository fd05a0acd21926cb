// Commands of occlusion queries (GL 1.5 §4.1.7, §6.1.12).
#include "gl/queries.h"

#include <algorithm>
#include <limits>

#include "gl/context.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

constexpr GLint kCounterBits = 64;

bool check_target(Context& ctx, GLenum target) {
    if (target == GL_SAMPLES_PASSED) return true;
    record_error(ctx, GL_INVALID_ENUM, "unknown query target");
    return false;
}

void end_active(Context& ctx) {
    begin_change(ctx, Dirty::kFragment);
    ctx.queries.active.reset();
}

// Nothing is drawn behind the caller's back, so a result is as available as it will ever be.
template <typename Value>
void get_query_object(Context& ctx, GLuint id, GLenum pname, Value* params) {
    const auto found = ctx.queries.objects.find(id);
    if (found == ctx.queries.objects.end() || !found->second->counter)
        return record_error(ctx, GL_INVALID_OPERATION, "there is no query of this name");
    const QueryObject& query = *found->second;
    if (ctx.queries.active.get() == &query)
        return record_error(ctx, GL_INVALID_OPERATION, "the query is active");
    switch (pname) {
        case GL_QUERY_RESULT_AVAILABLE:
            *params = GL_TRUE;
            return;
        case GL_QUERY_RESULT: {
            // Only draws that still wait for their pixels refer to the counter.
            if (query.counter.use_count() > 1) finish_drawing(ctx);
            constexpr std::uint64_t kMost = std::numeric_limits<Value>::max();
            *params = static_cast<Value>(std::min(query.counter->samples, kMost));
            return;
        }
    }
    record_error(ctx, GL_INVALID_ENUM, "no such query object parameter");
}

}  // namespace

void gen_queries(Context& ctx, GLsizei n, GLuint* ids) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    QueryState& queries = ctx.queries;
    GLsizei made = 0;
    try {
        for (; made < n; ++made) {
            while (queries.next_name == 0 || queries.objects.contains(queries.next_name)) ++queries.next_name;
            auto object = std::make_shared<QueryObject>();
            object->name = queries.next_name;
            queries.objects.emplace(object->name, std::move(object));
            ids[made] = queries.next_name++;
        }
    } catch (...) {
        while (made > 0) queries.objects.erase(ids[--made]);
        throw;
    }
}

// A query that is active ends first, as in the reference; GL 1.5 would have an error instead.
void delete_queries(Context& ctx, GLsizei n, const GLuint* ids) {
    if (n < 0) return record_error(ctx, GL_INVALID_VALUE, "n is negative");
    const auto is_active = [&](GLuint id) { return ctx.queries.active->name == id; };
    if (ctx.queries.active && std::any_of(ids, ids + n, is_active)) end_active(ctx);
    for (GLsizei i = 0; i < n; ++i) ctx.queries.objects.erase(ids[i]);
}

GLboolean is_query(Context& ctx, GLuint id) {
    const auto found = ctx.queries.objects.find(id);
    return found != ctx.queries.objects.end() && found->second->counter;
}

// Names need not come from GenQueries. A query that begins anew counts apart from draws that still wait.
void begin_query(Context& ctx, GLenum target, GLuint id) {
    if (!check_target(ctx, target)) return;
    if (ctx.queries.active) return record_error(ctx, GL_INVALID_OPERATION, "a query is active already");
    if (id == 0) return record_error(ctx, GL_INVALID_OPERATION, "0 names no query");
    begin_change(ctx, Dirty::kFragment);
    auto counter = std::make_shared<SampleCounter>();
    const auto found = ctx.queries.objects.find(id);
    auto object = found == ctx.queries.objects.end() ? std::make_shared<QueryObject>() : found->second;
    if (found == ctx.queries.objects.end()) ctx.queries.objects.emplace(id, object);
    object->name = id;
    object->counter = std::move(counter);
    ctx.queries.active = std::move(object);
}

void end_query(Context& ctx, GLenum target) {
    if (!check_target(ctx, target)) return;
    if (!ctx.queries.active) return record_error(ctx, GL_INVALID_OPERATION, "no query is active");
    end_active(ctx);
}

void get_queryiv(Context& ctx, GLenum target, GLenum pname, GLint* params) {
    if (!check_target(ctx, target)) return;
    switch (pname) {
        case GL_CURRENT_QUERY:
            *params = ctx.queries.active ? static_cast<GLint>(ctx.queries.active->name) : 0;
            return;
        case GL_QUERY_COUNTER_BITS:
            *params = kCounterBits;
            return;
    }
    record_error(ctx, GL_INVALID_ENUM, "no such query parameter");
}

void get_query_objectiv(Context& ctx, GLuint id, GLenum pname, GLint* params) {
    get_query_object(ctx, id, pname, params);
}

void get_query_objectuiv(Context& ctx, GLuint id, GLenum pname, GLuint* params) {
    get_query_object(ctx, id, pname, params);
}

}  // namespace terrazzo::gl
