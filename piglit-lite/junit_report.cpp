// Stage: piglit-lite, the JUnit file that meson and CI read.
#include <fmt/core.h>

#include "report/page.h"
#include "reports.h"

namespace terrazzo::piglit {

std::string junit_report(const std::vector<SceneReport>& reports) {
    std::string cases;
    std::size_t failures = 0, open = 0;
    double seconds = 0;
    for (const SceneReport& report : reports) {
        seconds += report.seconds;
        const std::string name = report.scene->name, chapter = chapter_of(*report.scene);
        cases += fmt::format("    <testcase name=\"{}\" classname=\"{}\" time=\"{:.3f}\"", name, chapter,
                             report.seconds);
        if (report.passed() && report.open) {
            ++open;
            cases += fmt::format("><skipped message=\"{}\"/></testcase>\n",
                                 report::escaped(report.scene->open_difference));
            continue;
        }
        if (report.passed()) {
            cases += "/>\n";
            continue;
        }
        ++failures;
        std::string text;
        for (const std::string& problem : report.problems) text += problem + "\n";
        cases += fmt::format(">\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n",
                             report::escaped(report.problems.front()), report::escaped(text));
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "  <testsuite name=\"piglit-lite\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" errors=\"0\" "
        "time=\"{:.3f}\">\n{}"
        "  </testsuite>\n</testsuites>\n",
        reports.size(), failures, open, seconds, cases);
}

}  // namespace terrazzo::piglit
