// Occlusion queries: names, the one that is active, counts through clears, early and late frames.
#include "gl/queries.h"

#include <gtest/gtest.h>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl/vertex_inline.h"
#include "gl_fixture.h"
#include "pipeline/schedule/statistics.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 200;  // several bins
constexpr GLuint kAll = kSize * kSize;

class QueriesTest : public GlTest {
  protected:
    QueriesTest() {
        attach_picture(ctx(), kSize, kSize);
        enable(ctx(), GL_DEPTH_TEST);
        depth_func(ctx(), GL_LEQUAL);
        clear(ctx(), GL_DEPTH_BUFFER_BIT);
    }

    void fill(GLfloat z) {
        begin(ctx(), GL_QUADS);
        vertex4f(ctx(), -1, -1, z, 1);
        vertex4f(ctx(), 1, -1, z, 1);
        vertex4f(ctx(), 1, 1, z, 1);
        vertex4f(ctx(), -1, 1, z, 1);
        end(ctx());
    }

    GLuint result(GLuint query) {
        GLuint samples = 77;
        get_query_objectuiv(ctx(), query, GL_QUERY_RESULT, &samples);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return samples;
    }

    GLint current_query() {
        GLint name = -1;
        get_queryiv(ctx(), GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &name);
        return name;
    }
};

TEST_F(QueriesTest, NamesBecomeQueriesWhenTheyBegin) {
    GLuint names[2];
    gen_queries(ctx(), 2, names);
    EXPECT_NE(names[0], names[1]);
    EXPECT_EQ(is_query(ctx(), names[0]), GL_FALSE);
    begin_query(ctx(), GL_SAMPLES_PASSED, names[0]);
    EXPECT_EQ(is_query(ctx(), names[0]), GL_TRUE);
    EXPECT_EQ(current_query(), static_cast<GLint>(names[0]));
    end_query(ctx(), GL_SAMPLES_PASSED);
    EXPECT_EQ(current_query(), 0);
    delete_queries(ctx(), 1, names);
    EXPECT_EQ(is_query(ctx(), names[0]), GL_FALSE);
    EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
}

TEST_F(QueriesTest, OneAtATime) {
    end_query(ctx(), GL_SAMPLES_PASSED);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    begin_query(ctx(), GL_SAMPLES_PASSED, 0);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    begin_query(ctx(), GL_SAMPLES_PASSED, 5);
    begin_query(ctx(), GL_SAMPLES_PASSED, 6);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    GLuint samples = 0;
    get_query_objectuiv(ctx(), 5, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION}) << "not while it is active";
    get_query_objectuiv(ctx(), 6, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
    const GLuint name = 5;
    delete_queries(ctx(), 1, &name);
    EXPECT_EQ(current_query(), 0);
}

TEST_F(QueriesTest, CountsWhatPassesAndNothingElse) {
    fill(0.5f);
    begin_query(ctx(), GL_SAMPLES_PASSED, 1);
    fill(0);
    end_query(ctx(), GL_SAMPLES_PASSED);
    fill(-0.5f);
    begin_query(ctx(), GL_SAMPLES_PASSED, 2);
    fill(0);
    end_query(ctx(), GL_SAMPLES_PASSED);
    EXPECT_EQ(result(1), kAll);
    EXPECT_EQ(result(2), 0u);
    EXPECT_EQ(result(1), kAll) << "asked again";
}

TEST_F(QueriesTest, ClearsDoNotTakeCountsAway) {
    begin_query(ctx(), GL_SAMPLES_PASSED, 1);
    fill(0);
    clear(ctx(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    fill(0.5f);
    end_query(ctx(), GL_SAMPLES_PASSED);
    clear(ctx(), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    EXPECT_EQ(result(1), 2 * kAll);
}

TEST_F(QueriesTest, AQueryThatBeginsAnewCountsFromZero) {
    begin_query(ctx(), GL_SAMPLES_PASSED, 1);
    fill(0);
    end_query(ctx(), GL_SAMPLES_PASSED);
    begin_query(ctx(), GL_SAMPLES_PASSED, 1);
    fill(0.5f);
    finish(ctx());
    fill(0);
    end_query(ctx(), GL_SAMPLES_PASSED);
    EXPECT_EQ(result(1), kAll);
    GLint samples = 0;
    get_query_objectiv(ctx(), 1, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(samples, static_cast<GLint>(kAll));
    get_query_objectiv(ctx(), 1, GL_QUERY_RESULT_AVAILABLE, &samples);
    EXPECT_EQ(samples, GL_TRUE);
}

// What `terrazzo run --stats` prints.
TEST_F(QueriesTest, StatisticsCountEveryPixelOnceWhoeverElseCounts) {
    pipeline::statistics.enabled = true;
    pipeline::statistics.pixels = 0;
    fill(0.5f);
    begin_query(ctx(), GL_SAMPLES_PASSED, 1);
    fill(0);
    fill(0.25f);
    end_query(ctx(), GL_SAMPLES_PASSED);
    fill(-0.5f);
    finish(ctx());
    pipeline::statistics.enabled = false;
    EXPECT_EQ(pipeline::statistics.pixels, 3 * kAll);
    EXPECT_EQ(result(1), kAll);
}

}  // namespace
}  // namespace terrazzo::gl
