// SPDX-License-Identifier: MIT
// What the report computes: statistics with known answers, fronts against the definition, rows of a results file, scales and colours of charts.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

#include "validation/study/report/page.hpp"
#include "validation/study/report/prices.hpp"
#include "viz/charts/palette.hpp"
#include "viz/charts/scale.hpp"

namespace gno::report {
namespace {

TEST(Statistics, MiddleAndSpread) {
    EXPECT_DOUBLE_EQ(median(std::vector{3.0, 1.0, 2.0}), 2);
    EXPECT_DOUBLE_EQ(median(std::vector{4.0, 1.0, 2.0, 3.0}), 2.5);
    EXPECT_DOUBLE_EQ(geometricMean(std::vector{1.0, 4.0, 16.0}), 4);
    EXPECT_DOUBLE_EQ(deviation(std::vector{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}), std::sqrt(32.0 / 7));
    EXPECT_TRUE(std::isnan(median({})));
    const Spread few = spreadOf(std::vector{5.0, 1.0, 3.0});
    EXPECT_DOUBLE_EQ(few.low, 1);
    EXPECT_DOUBLE_EQ(few.high, 5);
    const Spread many = spreadOf(std::vector{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 1000.0});
    EXPECT_DOUBLE_EQ(many.low, 2) << "from eight values on, one outlier does not stretch the range";
    EXPECT_DOUBLE_EQ(many.high, 6);
    EXPECT_TRUE(indistinguishable({2, 1, 3}, {3.5, 3, 4}));
    EXPECT_FALSE(indistinguishable({2, 1, 2.9}, {3.5, 3, 4}));
}

TEST(Fit, KnownExponents) {
    std::vector<double> x, exact, off;
    for (const double n : {1000.0, 4000.0, 16000.0, 64000.0}) {
        x.push_back(n);
        exact.push_back(3 * std::pow(n, 0.75));
    }
    const auto fit = fitPower(x, exact);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->exponent, 0.75, 1e-12);
    EXPECT_NEAR(fit->factor, 3, 1e-9);
    EXPECT_NEAR(*fit->standardError, 0, 1e-9);
    // ln y = 0, 1, 1, 2 at ln x = 0, 1, 2, 3: slope 3/5, residuals -0.1, 0.3, -0.3, 0.1, so the error of the slope is sqrt(0.2 / 2 / 5).
    const std::vector<double> e{1, std::exp(1), std::exp(2), std::exp(3)}, y{1, std::exp(1), std::exp(1), std::exp(2)};
    const auto scattered = fitPower(e, y);
    ASSERT_TRUE(scattered);
    EXPECT_NEAR(scattered->exponent, 0.6, 1e-12);
    EXPECT_NEAR(*scattered->standardError, std::sqrt(0.02), 1e-12);
    EXPECT_FALSE(fitPower(std::vector{1.0, 2.0}, std::vector{1.0, 2.0})->standardError) << "any line meets two points";
    EXPECT_FALSE(fitPower(std::vector{2.0, 2.0}, std::vector{1.0, 3.0}));
    EXPECT_FALSE(fitPower(std::vector{1.0, 2.0}, std::vector{0.0, 0.0}));
}

TEST(Front, KnownCosts) {
    //                              beaten by 2   front     front     equal to 2  beaten     front
    const std::vector<Cost> costs{{5, 10}, {1, 100}, {4, 10}, {4, 10}, {4, 11}, {9, 0}};
    EXPECT_EQ(paretoFront(costs), (std::vector<size_t>{1, 2, 5}));
    EXPECT_TRUE(paretoFront({}).empty());
}

/// Nobody may beat a cost on the front, and somebody must beat or equal each that is not.
TEST(Front, IsWhatItsDefinitionSays) {
    constexpr uint32_t kSeed = 3;
    SCOPED_TRACE(fmt::format("seed {}", kSeed));
    std::mt19937 random(kSeed);
    for (int round = 0; round < 500; ++round) {
        std::vector<Cost> costs;
        for (auto i = random() % 12; i > 0; --i) costs.push_back({double(random() % 6), double(random() % 6)});
        const auto beats = [](const Cost& a, const Cost& b) {
            return a.time <= b.time && a.error <= b.error && (a.time < b.time || a.error < b.error);
        };
        std::set<std::pair<double, double>> want, got;
        for (const Cost& cost : costs)
            if (std::none_of(costs.begin(), costs.end(), [&](const Cost& other) { return beats(other, cost); }))
                want.insert({cost.time, cost.error});
        const auto front = paretoFront(costs);
        for (const size_t i : front) got.insert({costs[i].time, costs[i].error});
        ASSERT_EQ(got, want);
        ASSERT_EQ(front.size(), want.size()) << "equal costs are named once";
        ASSERT_TRUE(std::is_sorted(front.begin(), front.end(), [&](size_t a, size_t b) { return costs[a].time < costs[b].time; }));
    }
}

/// A results file in a folder of its own.
class Rows {
public:
    Rows() : folder_(std::filesystem::temp_directory_path() / fmt::format("gnomon_report_{}", ::getpid())) {
        std::filesystem::create_directories(folder_);
    }
    ~Rows() { std::filesystem::remove_all(folder_); }
    Rows& add(const std::string& technique, const std::string& precision, std::vector<double> ms, uint64_t wrong, uint32_t frame = 0) {
        const std::string list = fmt::format("[{}]", fmt::join(ms, ","));
        text_ +=
            fmt::format(R"({{"schema":1,"kind":"gnomon-study","job":"{0}|{1}|{4}","group":"g{4}","name":"room","frame":{4},"light_kind":"point",)"
                        R"("technique":"{0}","precision":"{1}",)"
                        R"("size":[8,8],"samples":1000,"floor_ms":[1,1,1],"total_ms":{2},"passes":[{{"name":"top_build","ms":{2}}}],)"
                        R"("check":{{"checked":1000,"wrong":{3},"leaks":0,"false_dark":{3}}}}})",
                        technique, precision, list, wrong, frame) +
            "\n";
        return *this;
    }
    [[nodiscard]] Study study() const {
        std::ofstream(folder_ / "rows.jsonl") << text_;
        return arrange(loadResults(folder_ / "rows.jsonl"));
    }

private:
    std::filesystem::path folder_;
    std::string text_;
};

TEST(Prices, CheapestWithinEachError) {
    Rows rows;
    rows.add("fast", "published", {1, 1.1, 1.2}, 20)
        .add("slow", "certified", {5, 5.5, 6}, 0)
        .add("alike", "certified", {5.9, 6, 6.2}, 0)
        .add("far", "certified", {9, 9, 9}, 0);
    const Study study = rows.study();
    ASSERT_EQ(study.setups.size(), 1u);
    const auto prices = pricesOf(study.setups[0]);
    ASSERT_EQ(prices.size(), kThresholds.size());
    EXPECT_EQ(prices[0].cheapest->technique, "slow");
    ASSERT_EQ(prices[0].asGood.size(), 1u);
    EXPECT_EQ(prices[0].asGood[0]->technique, "alike");
    EXPECT_EQ(prices[4].cheapest->technique, "slow") << "20 of 1000 are 20000 ppm, more than 1000";
    EXPECT_EQ(prices[5].cheapest->technique, "slow");
    Rows right;
    right.add("fast", "published", {1, 1.1, 1.2}, 10).add("slow", "certified", {5, 5.5, 6}, 0);
    const Study other = right.study();
    EXPECT_EQ(pricesOf(other.setups[0])[4].cheapest->technique, "slow");
    EXPECT_EQ(pricesOf(other.setups[0])[5].cheapest->technique, "fast") << "10000 ppm are within 10000";
}

TEST(Findings, TellRatiosAndBrokenPromises) {
    Rows rows;
    rows.add("t", "published", {2, 2, 2}, 3).add("t", "certified", {2.5, 3, 3.5}, 0);
    const auto lines = findingsOf(rows.study());
    const auto has = [](const std::vector<std::string>& all, const std::string& part) {
        return std::any_of(all.begin(), all.end(), [&](const std::string& line) { return line.find(part) != std::string::npos; });
    };
    EXPECT_TRUE(has(lines, "t: certified costs 1.50x the time of published")) << fmt::format("{}", fmt::join(lines, "\n"));
    EXPECT_TRUE(has(lines, "published leaves 3000 ppm wrong at worst (room, light 0 (point)), certified none"));
    EXPECT_TRUE(has(lines, "Exactness is free nowhere"));
    EXPECT_FALSE(has(lines, "BROKEN PROMISE"));
    Rows broken;
    broken.add("t", "certified", {1, 1, 1}, 1);
    EXPECT_TRUE(has(findingsOf(broken.study()), "BROKEN PROMISE: on room, light 0 (point) t certified leaves 1 of 1000"));
}

TEST(Study, VariantsAreComparedOnTheFramesThatTheyShare) {
    Rows rows;
    for (const uint32_t frame : {0u, 1u}) rows.add("a", "certified", {1, 2, 4}, 1, frame).add("b", "certified", {3, 3, 3}, 0, frame);
    rows.add("a", "certified", {100, 100, 100}, 500, 2);
    const Study study = rows.study();
    EXPECT_EQ(study.setups[0].frames, (std::vector<uint32_t>{0, 1}));
    const Variant& a = *study.setups[0].find("a|certified||");
    EXPECT_DOUBLE_EQ(a.time.median, 2);
    EXPECT_EQ(a.wrong, 2u);
    EXPECT_DOUBLE_EQ(timeRatio(*study.setups[0].find("b|certified||"), a).median, 1.5);
}

TEST(Page, Encodings) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\x80"), "//6A");
    EXPECT_EQ(escaped("<a href=\"b\">&"), "&lt;a href=&quot;b&quot;&gt;&amp;");
}

TEST(Charts, Scales) {
    EXPECT_EQ(viz::tickText(0.001), "0.001");
    EXPECT_EQ(viz::tickText(1500), "1500");
    EXPECT_EQ(viz::tickText(15000), "15,000");
    EXPECT_EQ(viz::tickText(-123456), "-123,456");
    EXPECT_EQ(viz::tickText(2e7), "2e7");
    viz::Axis axis{"", true, "0 = exact", {}, {}, {}};
    const viz::Scale scale(axis, std::vector{0.0, 3.0, 4000.0});
    EXPECT_EQ(scale.ticks().front().second, "0 = exact");
    EXPECT_LT(*scale.place(0), *scale.zeroLine());
    EXPECT_LT(*scale.zeroLine(), *scale.place(3));
    EXPECT_GT(*scale.place(0), scale.low());
    EXPECT_LT(*scale.place(4000), scale.high());
    EXPECT_FALSE(scale.place(-1));
    EXPECT_FALSE(scale.place(std::nan("")));
    for (size_t i = 1; i < scale.ticks().size(); ++i) EXPECT_GT(scale.ticks()[i].first, scale.ticks()[i - 1].first);
    axis.zeroShare = 0.5;
    for (const double value :
         {3.0, 830.0, 99999.0}) {  // whatever the decades are, the row for zero is 1.2 of their 1 + 1.6 shares: who fills it relies on that
        const viz::Scale one(axis, std::vector{0.0, value});
        EXPECT_NEAR((*one.zeroLine() - one.low()) / (one.high() - one.low()), 1.2 * 0.5 / (1 + 1.6 * 0.5), 1e-12) << value;
    }
    axis.zeroRow.clear();
    EXPECT_FALSE(viz::Scale(axis, std::vector{0.0, 3.0}).place(0));
    EXPECT_FALSE(viz::Scale(axis, std::vector{1.0, 1.0}).ticks().empty()) << "one value has a scale, too";
}

/// CIE Lab under D65.
std::array<double, 3> labOf(const viz::Color& color) {
    std::array<double, 3> linear{};
    for (size_t i = 0; i < 3; ++i) {
        const double value = color[i] / 255.0;
        linear[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    const auto [r, g, b] = linear;
    const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505), y = root(0.2126 * r + 0.7152 * g + 0.0722 * b),
                 z = root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(Charts, ColorsStayAndDiffer) {
    const std::vector<std::string> names{"psv",        "d-psv", "d-stackless", "d-hybrid",  "forest",     "light-bvh",
                                         "light-grid", "ptsv",  "ptsv-2011",   "ray-query", "shadow-map", "embree"};
    const auto colors = viz::colorsOf(names);
    for (const auto& [name, color] : colors)
        for (const auto& [other, otherColor] : colors) {
            if (name >= other) continue;
            const auto a = labOf(color), b = labOf(otherColor);
            EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 25) << name << ", " << other;  // 2 is the least that is seen
        }
    auto more = names;
    more.push_back("zz-new");  // the last in the alphabet takes no colour from anybody
    for (const auto& [name, color] : colors) EXPECT_EQ(viz::colorsOf(more).at(name), color) << name;
}

}  // namespace
}  // namespace gno::report
