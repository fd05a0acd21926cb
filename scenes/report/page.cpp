// Stage: reports. Style and frame of our HTML pages.
#include "page.h"

#include <fstream>
#include <stdexcept>

namespace terrazzo::report {
namespace {

constexpr std::string_view kStyle = R"(
:root { --paper: #faf8f4; --ink: #26221d; --soft: #7d756a; --line: #ddd6ca; --card: #ffffff; --good: #2f7d4f;
        --bad: #b3372b; --warn: #a26a10; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #1b1a18; --ink: #ece7df; --soft: #9c948a; --line: #3a3732; --card: #242220; --good: #6cc18d;
          --bad: #ee8478; --warn: #e0b060; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1240px; padding: 2rem 1.25rem 4rem; background: var(--paper); color: var(--ink);
       font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.9rem; margin: 0 0 .25rem; letter-spacing: -.02em; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .75rem; border-bottom: 1px solid var(--line); padding-bottom: .3rem; }
h3 { font-size: 1rem; margin: 0; }
p.lead { color: var(--soft); margin: 0 0 1.5rem; max-width: 70ch; }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1rem; margin: 0 0 1rem; }
.card.bad { border-left: 4px solid var(--bad); }
.card.good { border-left: 4px solid var(--good); }
.theme { color: var(--soft); margin: .1rem 0 .8rem; }
.pictures { display: flex; flex-wrap: wrap; gap: .75rem; }
figure { margin: 0; }
figure img { display: block; width: 256px; height: auto; image-rendering: pixelated; border-radius: 4px; }
.large img { width: 372px; image-rendering: auto; }
figcaption { margin-top: .2rem; font-size: .8rem; color: var(--soft); }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .25rem .5rem; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { font-weight: 600; color: var(--soft); font-size: .82rem; }
th:first-child, td:first-child { text-align: left; }
.figures { overflow-x: auto; margin: .7rem 0 1rem; }
.good-text { color: var(--good); font-weight: 600; } .bad-text { color: var(--bad); font-weight: 600; }
.warn-text { color: var(--warn); font-weight: 600; }
ul.problems { margin: .6rem 0 0; padding-left: 1.2rem; color: var(--bad); }
a { color: inherit; }
nav { display: flex; flex-wrap: wrap; gap: .2rem .8rem; }
.totals { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
.totals div { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: .6rem 1.1rem; }
.totals b { display: block; font-size: 1.5rem; }
.totals span { color: var(--soft); font-size: .85rem; }
)";

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                // XML 1.0 allows no other control characters.
                if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') result += c;
        }
    return result;
}

std::string page_head(std::string_view title) {
    std::string page = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>";
    page += escaped(title);
    page += "</title>\n<style>";
    page += kStyle;
    page += "</style></head><body>\n";
    return page;
}

std::string page_foot() {
    return "</body></html>\n";
}

void write_text(const std::string& path, std::string_view text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.flush();
    if (!file) throw std::runtime_error("cannot write " + path);
}

}  // namespace terrazzo::report
