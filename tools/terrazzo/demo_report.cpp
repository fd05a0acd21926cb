// Stage: the demo's page and contact sheet.
#include "demo_report.h"

#include <fmt/core.h>

#include "report/figures.h"
#include "report/page.h"
#include "report/pictures.h"

namespace terrazzo {
namespace {

using report::escaped;

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
    std::vector<std::vector<double>> ratios(threads.size());
    for (const DemoScene& scene : scenes) {
        html += fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td>", escaped(scene.name));
        for (std::size_t i = 0; i < threads.size(); ++i) {
            const bench::Measurement* ours = find(scene, kOurs, threads[i]);
            const bench::Measurement* theirs = find(scene, kTheirs, threads[i]);
            const double ratio = ours && theirs ? speed_ratio(*ours, *theirs) : 0;
            html += speed_cells(ours) + speed_cells(theirs) + ratio_cell(ours, theirs, ratio);
            if (ours && theirs) ratios[i].push_back(ratio);
        }
        html += start_and_memory_cells(find(scene, kOurs, threads.front()),
                                       find(scene, kTheirs, threads.front()));
        html += "</tr>\n";
    }
    html += "<tr><td>geometric mean</td>";
    for (const std::vector<double>& values : ratios)
        html += fmt::format("<td></td><td></td><td>{:.2f}x</td>", bench::geometric_mean(values));
    return html + "</tr></table></div>\n";
}

std::string card(const DemoScene& scene) {
    std::string html =
        fmt::format("<div class=\"card {}\" id=\"{}\"><h3>{}</h3><div class=\"theme\">{}</div>",
                    scene.failures.empty() ? "good" : "bad", escaped(scene.name), escaped(scene.name),
                    escaped(scene.description));
    html += report::comparison(scene.ours, kOurs, scene.theirs, kTheirs);
    if (scene.ours && scene.theirs)
        html += fmt::format(
            "<div class=\"theme\">{} pixels differ by more than one step of 255; largest difference: "
            "{:.0f}</div>",
            scene.pixels_off, scene.largest_difference);
    if (!scene.failures.empty()) {
        html += "<ul class=\"problems\">";
        for (const std::string& failure : scene.failures) html += "<li>" + escaped(failure) + "</li>";
        html += "</ul>";
    }
    return html + "</div>\n";
}

void tile(std::string& html, const std::string& figure, const std::string& what) {
    html += fmt::format("<div><b>{}</b><span>{}</span></div>", figure, what);
}

// The page in a few figures.
std::string totals(const std::vector<DemoScene>& scenes, const std::vector<int>& threads,
                   const DemoPrograms& programs) {
    std::vector<double> speeds, starts;
    std::size_t pictures = 0, agreeing = 0;
    for (const DemoScene& scene : scenes) {
        if (scene.ours && scene.theirs) ++pictures, agreeing += scene.agrees();
        const bench::Measurement* const ours = find(scene, kOurs, threads.front());
        const bench::Measurement* const theirs = find(scene, kTheirs, threads.front());
        if (!ours || !theirs) continue;
        speeds.push_back(speed_ratio(*ours, *theirs));
        starts.push_back(bench::median(theirs->first_frame_seconds) /
                         bench::median(ours->first_frame_seconds));
    }
    for (const DemoProgram& program : programs.programs) ++pictures, agreeing += program.agrees();
    std::string html = "<div class=\"totals\">";
    if (const double mean = mean_ratio(programs); mean > 0)
        tile(html, fmt::format("{:.1f}x", mean), "the frames a second of programs in windows");
    if (!speeds.empty()) {
        tile(html, fmt::format("{:.1f}x", bench::geometric_mean(speeds)), "the frames a second of scenes");
        tile(html, fmt::format("{:.1f}x", bench::geometric_mean(starts)), "sooner with the first frame");
    }
    tile(html, fmt::format("{} / {}", agreeing, pictures),
         "pictures agree: 99.9 % of their pixels are within one step of 255");
    return html + "</div>\n";
}

// Ours, theirs, difference.
void add_to_sheet(const report::OptionalPicture& ours, const report::OptionalPicture& theirs,
                  std::vector<OIIO::ImageBuf>& pictures) {
    const OIIO::ImageBuf nothing(OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8));
    pictures.push_back(ours ? *ours : nothing);
    pictures.push_back(theirs ? *theirs : nothing);
    pictures.push_back(ours && theirs ? report::magnified_difference(*ours, *theirs, report::kMagnification)
                                      : nothing);
}

}  // namespace

std::string demo_page(const std::vector<DemoScene>& scenes, const std::vector<int>& threads,
                      const DemoPrograms& programs) {
    std::string html = report::page_head("Terrazzo beside Mesa");
    html +=
        "<h1>Terrazzo beside Mesa</h1><p class=\"lead\">OpenGL drawn by this processor, twice: by Terrazzo "
        "and by Mesa's llvmpipe. Differences are magnified by 32: one step of 255 is a visible tone, black "
        "is "
        "the same colour to the bit.</p>\n";
    html += totals(scenes, threads, programs);
    html += programs_section(programs);
    html +=
        "<h2>Scenes and models through OSMesa</h2><p class=\"lead\">The same programs drawn through the two "
        "libraries, each in its own process. Speeds are medians over interleaved rounds, every frame ended "
        "by glFinish; the first frame counts from the start of the process; memory is the process's highest "
        "resident set.</p>\n";
    html += summary(scenes, threads);
    for (const DemoScene& scene : scenes) html += card(scene);
    return html + report::page_foot();
}

OIIO::ImageBuf demo_contact_sheet(const std::vector<DemoScene>& scenes, const DemoPrograms& programs) {
    constexpr int kColumns = 6, kCell = 320;
    std::vector<OIIO::ImageBuf> pictures;
    for (const DemoProgram& program : programs.programs) add_to_sheet(program.ours, program.theirs, pictures);
    for (const DemoScene& scene : scenes) add_to_sheet(scene.ours, scene.theirs, pictures);
    return report::contact_sheet(pictures, kColumns, kCell);
}

}  // namespace terrazzo
