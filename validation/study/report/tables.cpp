// SPDX-License-Identifier: MIT
#include "validation/study/report/tables.hpp"

#include <fmt/format.h>

#include "validation/study/report/page.hpp"
#include "validation/study/report/prices.hpp"

namespace gno::report {
namespace {

Cell number(double value, const std::string& format) { return {fmt::format(fmt::runtime(format), value), value}; }
Cell wrongCell(double perMillionSamples) { return number(perMillionSamples, perMillionSamples < 10000 ? "{:.4g}" : "{:.0f}"); }
Cell whole(uint64_t value) { return {fmt::format("{}", value), double(value)}; }
Cell spread(const Spread& value) { return {times(value), value.median}; }

std::string settingsOf(const Row& row) {
    std::string text;
    for (const std::string& name : row.varied)
        if (row.settings.contains(name)) {
            const auto& value = row.settings.at(name);
            text += fmt::format("{}{}={}{}", text.empty() ? "" : " ", name, value.is_string() ? value.get<std::string>() : value.dump(),
                                name == row.bestOf ? " (best)" : "");
        }
    return text.empty() ? row.bestOf.empty() ? "default" : fmt::format("default (best {})", row.bestOf) : text;
}

}  // namespace

Table priceTable(const Study& study) {
    Table table{"prices",
                "Cheapest technique within an error",
                {"scene and light", "wrong, at most (ppm)", "cheapest", "time / bare pass", "wrong (ppm)", "bytes, MiB",
                 "as fast, as far as the repeats tell"},
                {}};
    for (const Setup& setup : study.setups)
        for (const Price& price : pricesOf(setup)) {
            std::vector<Cell> row{{setup.title, {}}, {price.threshold == 0 ? "0 = exact" : fmt::format("{:g}", price.threshold), price.threshold}};
            if (price.cheapest == nullptr) {
                row.insert(row.end(), {{"nothing is that right", {}}, {}, {}, {}, {}});
            } else {
                row.insert(row.end(), {{price.cheapest->fullName(), {}},
                                       spread(price.cheapest->time),
                                       wrongCell(price.cheapest->wrongPerMillion()),
                                       number(double(price.cheapest->bytes) / 1048576, "{:.2f}"),
                                       {namesOf(price.asGood), {}}});
            }
            table.rows.push_back(std::move(row));
        }
    return table;
}

Table ladderTable(const Study& study) {
    Table table{"rungs",
                "Every variant of every scene and light",
                {"scene and light", "technique", "precision", "settings", "time / bare pass", "time / fastest", "wrong (ppm)", "leaks", "false dark",
                 "bytes, MiB"},
                {}};
    for (const Setup& setup : study.setups) {
        const Variant* fastest = nullptr;
        for (const Variant& variant : setup.variants)
            if (variant.isMeasured() && !variant.peer && (fastest == nullptr || variant.time.median < fastest->time.median)) fastest = &variant;
        for (const Variant& variant : setup.variants) {
            const std::string name = variant.fullName(), lead = variant.technique + " " + variant.precision;
            std::vector<Cell> row{{setup.title, {}},
                                  {variant.technique, {}},
                                  {variant.precision, {}},
                                  {name.size() > lead.size() ? name.substr(lead.size() + 1) : "default", {}}};
            if (!variant.isMeasured())
                row.insert(row.end(), {{"unavailable: " + variant.unavailable, {}}, {}, {}, {}, {}, {}});
            else
                row.insert(row.end(), {spread(variant.time), fastest != nullptr ? spread(timeRatio(variant, *fastest)) : Cell{},
                                       variant.isChecked() ? wrongCell(variant.wrongPerMillion()) : Cell{"not checked", {}}, whole(variant.leaks),
                                       whole(variant.wrong - variant.leaks), number(double(variant.bytes) / 1048576, "{:.2f}")});
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

Table rowTable(const Study& study) {
    Table table{"rows",
                "All rows of the results file",
                {"scene", "light", "frame", "size", "casters", "technique", "precision", "settings", "total, ms", "time / bare pass", "wrong (ppm)",
                 "leaks", "false dark", "nodes per sample", "test-and-set", "bytes, MiB"},
                {}};
    for (const Row& row : study.results.rows) {
        std::vector<Cell> cells{{row.name, {}},      {fmt::format("{} ({})", row.light, row.lightKind), double(row.light)},
                                whole(row.frame),    {fmt::format("{}x{}", row.size[0], row.size[1]), double(row.size[0]) * row.size[1]},
                                whole(row.casters),  {row.technique, {}},
                                {row.precision, {}}, {settingsOf(row), {}}};
        if (!row.isMeasured()) {
            cells.insert(cells.end(), {{"unavailable: " + row.unavailable, {}}, {}, {}, {}, {}, {}, {}, {}});
        } else {
            const bool isChecked = row.check && row.check->checked > 0;
            cells.insert(cells.end(), {number(median(row.totalMs), "{:.3f}"), spread(spreadOf(row.toFloor(row.totalMs))),
                                       isChecked ? wrongCell(1e6 * double(row.check->wrong) / double(row.check->checked)) : Cell{"not checked", {}},
                                       isChecked ? whole(row.check->leaks) : Cell{}, isChecked ? whole(row.check->falseDark) : Cell{},
                                       number(row.samples > 0 ? double(row.counter("visited_nodes")) / double(row.samples) : 0, "{:.1f}"),
                                       whole(row.counter("test_and_set")), number(double(row.totalBytes()) / 1048576, "{:.2f}")});
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::string htmlOf(const Table& table) {
    std::string html = fmt::format(
        "<div class=\"table\" id=\"{}\"><label>Filter <input type=\"search\" placeholder=\"words, all must match\"></label> <span class=\"count\" "
        "aria-live=\"polite\"></span>\n<div class=\"wide\"><table><caption>{}</caption><thead><tr>",
        table.id, escaped(table.caption));
    for (const std::string& header : table.headers)
        html += fmt::format("<th scope=\"col\" aria-sort=\"none\"><button type=\"button\">{}</button></th>", escaped(header));
    html += "</tr></thead><tbody>\n";
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (const Cell& cell : row)
            html += cell.value ? fmt::format("<td data-v=\"{}\">{}</td>", *cell.value, escaped(cell.text))
                               : fmt::format("<td>{}</td>", escaped(cell.text));
        html += "</tr>\n";
    }
    return html + "</tbody></table></div></div>\n";
}

}  // namespace gno::report
