// SPDX-License-Identifier: MIT
#include "validation/study/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "validation/study/report/page_files.hpp"
#include "validation/study/report/prices.hpp"
#include "validation/study/report/tables.hpp"

namespace gno::report {
namespace {

struct Section {
    const char *id, *title, *text;
};

constexpr std::array kSections{
    Section{"overview", "At a glance",
            "One point is one technique at one precision and setting. The lowest row answers every sample right; the grey steps join what nothing "
            "else beats in both time and error."},
    Section{"error_time", "Error against time, scene by scene",
            "Times are ratios to a pass that only reads the view samples and writes a mask, measured in turns with the technique. Peers (hollow) "
            "answer the same samples on the same cores and are not part of the front."},
    Section{"ladder", "The precision ladder",
            "Published is the algorithm as its paper has it, conservative adds bounds on rounding, certified is proven to be exact."},
    Section{"growth", "Growth",
            "Exponents of time and counters. Times of different scenes and sizes come from different moments of a run; counters are exact."},
    Section{"paths", "Along a path", ""},
    Section{"distance", "Where wrong samples lie", "Distance to the nearest boundary between shadow and light in the exact mask."},
};

std::string image(const std::string& png) { return "data:image/png;base64," + base64(png); }

std::string facts(const Study& study) {
    size_t unavailable = 0;
    for (const Row& row : study.results.rows) unavailable += !row.isMeasured();
    return fmt::format("<p class=\"facts\">{} rows{} of {} scenes and lights; {}; {}. Made by <code>gnomon-study report {}</code>.</p>\n",
                       study.results.rows.size(), unavailable > 0 ? fmt::format(" ({} unavailable)", unavailable) : "", study.setups.size(),
                       escaped(study.device), escaped(study.sizes()), escaped(study.results.file.filename().string()));
}

std::string figuresOf(const std::vector<DrawnFigure>& figures, const std::string& section) {
    std::string html;
    size_t count = 0;
    for (const DrawnFigure& figure : figures) {
        if (figure.what.section != section) continue;
        const bool isFolded = (section == "ladder" || section == "growth" || section == "paths" || section == "distance") && count > 2;
        if (isFolded) html += fmt::format("<details><summary>{}</summary>", escaped(figure.what.figure.title));
        html += fmt::format(
            "<figure id=\"{0}\"><img class=\"chart\" width=\"{1}\" height=\"{2}\" alt=\"{3}\" src=\"{4}\"><figcaption>{5} <span "
            "class=\"facts\">({0}.png)</span></figcaption></figure>\n",
            escaped(figure.what.file), figure.what.figure.width, figure.what.figure.height, escaped(figure.what.figure.title), image(figure.png),
            escaped(figure.what.caption));
        if (isFolded) html += "</details>\n";
        ++count;
    }
    return html;
}

std::string comparison(const WorstFrame& worst) {
    const Row& row = *worst.row;
    const std::string technique = escaped(fmt::format("{} {}", row.technique, row.precision)), shaded = image(worst.shaded);
    std::string html = fmt::format(
        "<div class=\"compare\"><h3>{}: {}, light {}, frame {}</h3><p class=\"facts\">{} of {} samples wrong ({}): {} leaks, {} false darks. Left: "
        "the technique; right: the exact answer.</p>\n",
        technique, escaped(row.name), row.light, row.frame, row.check->wrong, row.check->checked,
        perMillion(1e6 * double(row.check->wrong) / double(row.check->checked)), row.check->leaks, row.check->falseDark);
    html += fmt::format(
        "<div class=\"view\" tabindex=\"0\" role=\"group\" aria-label=\"pictures of {}; plus and minus zoom, arrows move\"><div "
        "class=\"layers\"><img alt=\"exact answer\" src=\"{}\"><img class=\"left\" alt=\"{}\" src=\"{}\"></div><div class=\"edge\"></div></div>\n",
        technique, image(worst.truth), technique, shaded);
    html += fmt::format(
        "<div class=\"controls\"><label>left <select><option value=\"shaded\">as it looks</option>{}</select></label><input type=\"range\" "
        "min=\"0\" "
        "max=\"100\" step=\"0.5\" value=\"50\" aria-label=\"edge between {} and the exact answer\">"
        "<button type=\"button\" data-zoom=\"out\" aria-label=\"zoom out\">-</button><button type=\"button\" data-zoom=\"in\" aria-label=\"zoom "
        "in\">+</button><button type=\"button\" data-zoom=\"reset\">whole picture</button><output class=\"zoom\"></output></div>\n",
        worst.wrong.empty() ? "" : "<option value=\"wrong\">wrong samples marked</option>", technique);
    html += fmt::format("<template data-layer=\"shaded\" data-src=\"{}\"></template>", shaded);
    if (!worst.wrong.empty()) html += fmt::format("<template data-layer=\"wrong\" data-src=\"{}\"></template>", image(worst.wrong));
    return html + "</div>\n";
}

std::string pictures(const Study& study, const std::vector<WorstFrame>& worst) {
    std::string html =
        "<h2 id=\"pictures\">Pictures: where each technique is worst</h2>\n<p>The slider moves the edge between the technique and the exact answer. "
        "Click a picture, then the wheel or + and - zoom and dragging moves it.</p>\n";
    for (const WorstFrame& frame : worst) html += comparison(frame);
    if (worst.empty()) html += "<p>The results file names no pictures of a wrong answer.</p>\n";
    std::string never;
    for (const std::string& technique : study.techniques) {
        bool checked = false, wrong = false;
        for (const Row& row : study.results.rows)
            if (row.technique == technique && row.check) checked = true, wrong = wrong || row.check->wrong > 0;
        if (checked && !wrong) never += (never.empty() ? "" : ", ") + technique;
    }
    return never.empty() ? html : html + fmt::format("<p>Never wrong in this study, at any precision: {}.</p>\n", escaped(never));
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

std::string base64(const std::string& bytes) {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](size_t at) { return at < bytes.size() ? uint32_t(uint8_t(bytes[at])) : 0u; };
        const uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        for (size_t digit = 0; digit < 4; ++digit) text += i + digit <= bytes.size() ? kDigits[group >> (18 - 6 * digit) & 63] : '=';
    }
    return text;
}

std::string makePage(const Study& study, const std::vector<DrawnFigure>& figures, const std::vector<WorstFrame>& worst) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>What accuracy costs</title><link rel=\"icon\" href=\"data:,\">\n<style>\n{}</style></head><body>\n<h1>What accuracy costs in "
        "time</h1>\n",
        kPageCss);
    html += facts(study);
    for (const std::string& problem : study.results.problems) html += fmt::format("<p class=\"problem\">{}</p>\n", escaped(problem));
    html += "<nav aria-label=\"sections\">";
    std::string sections;
    for (const Section& section : kSections) {
        std::string body = figuresOf(figures, section.id);
        if (section.id == std::string("ladder") && !body.empty()) body += htmlOf(ladderTable(study));
        if (section.id == std::string("error_time"))
            body += "<h3 id=\"pay\">For this scene and this error you pay this</h3>\n" + htmlOf(priceTable(study));
        if (body.empty()) continue;
        html += fmt::format("<a href=\"#{}\">{}</a>", section.id, section.title);
        sections += fmt::format("<h2 id=\"{}\">{}</h2>\n<p>{}</p>\n{}", section.id, section.title, section.text, body);
        if (section.id != std::string("overview")) continue;
        sections +=
            "<h2 id=\"findings\">What the numbers say</h2>\n<p class=\"facts\">Every sentence is computed from the rows. 1.31x (1.25..1.40): median "
            "of the repeats, then the lowest and highest (from eight repeats on: the quartiles).</p>\n<ul class=\"findings\">\n";
        for (const std::string& line : findingsOf(study)) sections += fmt::format("<li>{}</li>\n", escaped(line));
        sections += "</ul>\n";
    }
    html += "<a href=\"#pay\">Prices</a><a href=\"#pictures\">Pictures</a><a href=\"#all\">All rows</a></nav>\n" + sections + pictures(study, worst);
    html += "<h2 id=\"all\">All rows</h2>\n" + htmlOf(rowTable(study));
    return html + fmt::format("<script>\n{}</script>\n</body></html>\n", kPageJs);
}

}  // namespace gno::report
