// Stage: the demo's page and contact sheet.
#include "demo_report.h"

#include <fmt/core.h>

#include <cmath>

#include "report/page.h"
#include "report/pictures.h"

namespace terrazzo {
namespace {

using report::escaped;

constexpr float kMagnification = 32;
constexpr int kPicture = 512;  // size in the page

const bench::Measurement* find(const DemoScene& scene, const char* label, int threads) {
    for (const bench::Measurement& m : scene.speed.measurements)
        if (m.contender.label == label && m.contender.threads == threads && m.measured()) return &m;
    return nullptr;
}

double frames_per_second(const bench::Measurement& m) {
    return 1 / bench::median(m.frame_seconds);
}

// Empty text when one of the two is missing.
std::string ratio_cell(const bench::Measurement* ours, const bench::Measurement* theirs, double ratio) {
    if (!ours || !theirs) return "<td></td>";
    return fmt::format("<td class=\"{}\">{:.2f}x</td>", ratio >= 1 ? "good-text" : "bad-text", ratio);
}

std::string speed_cells(const bench::Measurement* m) {
    return m ? fmt::format("<td>{:.1f}</td>", frames_per_second(*m)) : "<td>failed</td>";
}

double speed_ratio(const bench::Measurement& ours, const bench::Measurement& theirs) {
    return frames_per_second(ours) / frames_per_second(theirs);
}

std::string summary_header(const std::vector<int>& threads) {
    std::string html = "<tr><th>scene</th>";
    for (const int count : threads)
        html += fmt::format("<th>FPS, {0}</th><th>{1}</th><th>ratio</th>",
                            count == 0   ? "caller"
                            : count == 1 ? "1 thread"
                                         : fmt::format("{} threads", count),
                            kTheirs);
    return html + fmt::format(
                      "<th>first, ms</th><th>{0}</th><th>ratio</th><th>peak, MB</th><th>{0}</th>"
                      "<th>ratio</th></tr>\n",
                      kTheirs);
}

struct Means {
    double sum = 0;
    int count = 0;
    void add(double ratio) {
        sum += std::log(ratio);
        ++count;
    }
    std::string text() const { return count ? fmt::format("{:.2f}x", std::exp(sum / count)) : ""; }
};

std::string start_and_memory_cells(const bench::Measurement* ours, const bench::Measurement* theirs) {
    std::string html;
    const auto pair = [&](auto values, double scale) {
        const double a = ours ? bench::median(values(*ours)) * scale : 0;
        const double b = theirs ? bench::median(values(*theirs)) * scale : 0;
        html += ours ? fmt::format("<td>{:.1f}</td>", a) : "<td>failed</td>";
        html += theirs ? fmt::format("<td>{:.1f}</td>", b) : "<td>failed</td>";
        html += ratio_cell(ours, theirs, b / a);
    };
    pair([](const bench::Measurement& m) { return m.first_frame_seconds; }, 1e3);
    pair([](const bench::Measurement& m) { return m.peak_resident_kib; }, 1.0 / 1024);
    return html;
}

std::string summary(const std::vector<DemoScene>& scenes, const std::vector<int>& threads) {
    std::string html = "<div class=\"figures\"><table>" + summary_header(threads);
    std::vector<Means> means(threads.size());
    for (const DemoScene& scene : scenes) {
        html += fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td>", escaped(scene.name));
        for (std::size_t i = 0; i < threads.size(); ++i) {
            const bench::Measurement* ours = find(scene, kOurs, threads[i]);
            const bench::Measurement* theirs = find(scene, kTheirs, threads[i]);
            const double ratio = ours && theirs ? speed_ratio(*ours, *theirs) : 0;
            html += speed_cells(ours) + speed_cells(theirs) + ratio_cell(ours, theirs, ratio);
            if (ours && theirs) means[i].add(ratio);
        }
        html += start_and_memory_cells(find(scene, kOurs, threads.front()),
                                       find(scene, kTheirs, threads.front()));
        html += "</tr>\n";
    }
    html += "<tr><td>geometric mean</td>";
    for (const Means& mean : means) html += "<td></td><td></td><td>" + mean.text() + "</td>";
    return html + "</tr></table></div>\n";
}

OIIO::ImageBuf difference(const DemoScene& scene) {
    return report::magnified_difference(*scene.ours, *scene.theirs, kMagnification);
}

std::string figure(const OIIO::ImageBuf& picture, const std::string& caption) {
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"{1}\" style=\"width:360px;image-rendering:auto\">"
        "<figcaption>{0}</figcaption></figure>\n",
        escaped(caption), report::png_data_uri(picture, kPicture));
}

std::string card(const DemoScene& scene) {
    std::string html =
        fmt::format("<div class=\"card {}\" id=\"{}\"><h3>{}</h3><div class=\"theme\">{}</div>",
                    scene.failures.empty() ? "good" : "bad", escaped(scene.name), escaped(scene.name),
                    escaped(scene.description));
    html += "<div class=\"pictures\">";
    if (scene.ours) html += figure(*scene.ours, kOurs);
    if (scene.theirs) html += figure(*scene.theirs, kTheirs);
    if (scene.ours && scene.theirs) {
        html += figure(difference(scene), fmt::format("difference x {:g}", kMagnification));
        html += fmt::format(
            "</div><div class=\"theme\">{} pixels differ by more than one step of 255; the largest "
            "difference is {:.0f} steps</div>",
            scene.pixels_off, scene.largest_difference);
    } else {
        html += "</div>";
    }
    if (!scene.failures.empty()) {
        html += "<ul class=\"problems\">";
        for (const std::string& failure : scene.failures) html += "<li>" + escaped(failure) + "</li>";
        html += "</ul>";
    }
    return html + "</div>\n";
}

}  // namespace

std::string demo_page(const std::vector<DemoScene>& scenes, const std::vector<int>& threads) {
    std::string html = report::page_head("Terrazzo beside OSMesa");
    html +=
        "<h1>Terrazzo beside OSMesa</h1><p class=\"lead\">The same programs drawn through the two libraries, "
        "each "
        "in its own process. Speeds are medians over interleaved rounds, every frame ended by glFinish; the "
        "first "
        "frame counts from the start of the process; memory is the process's highest resident set.</p>\n";
    html += "<h2>Figures</h2>" + summary(scenes, threads);
    html += "<h2>Pictures</h2>";
    for (const DemoScene& scene : scenes) html += card(scene);
    return html + report::page_foot();
}

OIIO::ImageBuf demo_contact_sheet(const std::vector<DemoScene>& scenes) {
    constexpr int kColumns = 6, kCell = 320;
    const OIIO::ImageBuf nothing(OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8));
    std::vector<OIIO::ImageBuf> pictures;
    for (const DemoScene& scene : scenes) {
        pictures.push_back(scene.ours ? *scene.ours : nothing);
        pictures.push_back(scene.theirs ? *scene.theirs : nothing);
        pictures.push_back(scene.ours && scene.theirs ? difference(scene) : nothing);
    }
    return report::contact_sheet(pictures, kColumns, kCell);
}

}  // namespace terrazzo
