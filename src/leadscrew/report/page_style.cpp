#include <leadscrew/markup/markup.hpp>
#include <leadscrew/report/page_parts.hpp>
#include <leadscrew/report/path_view.hpp>

namespace leadscrew::report {
namespace {

using markup::put;

constexpr std::string_view light = R"(
--page:#fbfbf8;--card:#ffffff;--text:#1b2126;--quiet:#5b666e;--line:#dde1e2;--grid:#e9ecec;--band:#1d6d8c;--limit:#b4471f;
--good:#14694a;--good-back:#e8f3ee;--bad:#a83a12;--bad-back:#fbeee8;--mark:#1b2126;)";

constexpr std::string_view dark = R"(
--page:#13171a;--card:#1a1f23;--text:#e3e7ea;--quiet:#9aa6ae;--line:#30373c;--grid:#272e33;--band:#5db6d4;--limit:#ee8f66;
--good:#7fd0ae;--good-back:#17302a;--bad:#f3a17e;--bad-back:#38211a;--mark:#e3e7ea;)";

constexpr std::string_view rules = R"(
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--text);font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans",
"DejaVu Sans",sans-serif;font-variant-numeric:tabular-nums;-webkit-text-size-adjust:100%}
main{max-width:1240px;margin:0 auto;padding:36px 28px 64px}
.over{margin:0;color:var(--quiet);font-size:13px;letter-spacing:.02em}
h1{margin:2px 0 18px;font-size:30px;line-height:1.2;font-weight:650;letter-spacing:-.01em;overflow-wrap:anywhere}
h2{margin:52px 0 10px;padding-top:14px;border-top:1px solid var(--line);font-size:20px;font-weight:620}
h3{margin:0 0 4px;font-size:15px;font-weight:620}
p{margin:0 0 10px;max-width:75ch}
.note{color:var(--quiet);font-size:13px}
.verdict{padding:14px 18px;border-left:4px solid;border-radius:4px;margin:0 0 26px}
.verdict strong{display:block;font-size:18px;font-weight:620}
.verdict ul{margin:4px 0 0;padding-left:20px}
.verdict.good{background:var(--good-back);border-color:var(--good)}.verdict.good strong{color:var(--good)}
.verdict.bad{background:var(--bad-back);border-color:var(--bad)}.verdict.bad strong{color:var(--bad)}
.verdict.idle{background:var(--card);border-color:var(--quiet)}
.figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(150px,1fr));gap:20px 28px;margin:0}
.figures dt{color:var(--quiet);font-size:13px}
.figures dd{margin:0;font-size:22px;line-height:1.3;font-weight:560;white-space:nowrap}
.figures small{display:block;color:var(--quiet);font-size:13px;font-weight:400;white-space:normal}
.card,.axis{margin:0;padding:12px 14px;background:var(--card);border:1px solid var(--line);border-radius:6px}
.views{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:16px;margin:14px 0 10px}
figcaption{color:var(--quiet);font-size:13px}figcaption b{color:var(--text);font-weight:600}
.card svg{display:block;width:100%;height:auto}
.grid{fill:none;stroke:var(--grid);vector-effect:non-scaling-stroke}
.card .grid{stroke-width:1}
.ticks text{font-size:12px;fill:var(--quiet)}.letter{font-size:13px;font-weight:600;fill:var(--quiet)}
.triad{fill:none;stroke:var(--quiet);stroke-width:1.5}
.mark{stroke:var(--mark);stroke-width:14;fill:none}
.speeds{max-width:520px}.bar{display:flex;height:10px;border-radius:2px;overflow:hidden}.bar i{flex:1}
.marks,.times{position:relative;height:20px;font-size:12px;color:var(--quiet)}
.marks span,.times span{position:absolute;transform:translateX(-50%);white-space:nowrap}
.marks .b,.times .b{transform:none}.marks .e,.times .e{transform:translateX(-100%)}
.axes{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(350px,100%),1fr));gap:16px;margin-top:16px}
.chart{margin:0 0 8px}
.chart figcaption{display:flex;flex-wrap:wrap;gap:0 6px;align-items:baseline}
.chart .peak{margin-left:auto}
.chart output{margin-left:auto;color:var(--text);font-weight:600}.chart output:empty,.chart output:not(:empty)+.peak{display:none}
.plot{position:relative;height:92px;margin-left:64px;border-left:1px solid var(--line);border-bottom:1px solid var(--line);
touch-action:pan-y;cursor:crosshair;user-select:none;-webkit-user-select:none}
.large .plot{height:170px}
.plot svg{display:block;width:100%;height:100%;overflow:hidden}
.times{margin-left:64px}
.band{fill:var(--band);fill-opacity:.28;stroke:var(--band);stroke-width:1.25;stroke-linejoin:round;
vector-effect:non-scaling-stroke}
.limit{fill:none;stroke:var(--limit);stroke-width:1.25;stroke-dasharray:5 4;vector-effect:non-scaling-stroke}
.slides svg path{fill:none;vector-effect:non-scaling-stroke;stroke-linejoin:round}
.slides path.ideal{stroke:var(--line);stroke-width:7;stroke-linecap:round}
.slides path.commanded{stroke:var(--band);stroke-width:1.5;stroke-dasharray:7 5}
.slides path.actual{stroke:var(--limit);stroke-width:1.5;display:none}
#magnify0:checked~svg .by0,#magnify1:checked~svg .by1,#magnify2:checked~svg .by2{display:inline}
.slides label{margin:0 16px 0 4px;font-size:13px}
.keys{margin:6px 0;color:var(--quiet);font-size:13px}
.keys i{display:inline-block;width:26px;margin:0 6px 0 14px;vertical-align:middle;border-top:2px solid var(--limit)}
.keys i.ideal{border-top:7px solid var(--line)}.keys i.commanded{border-top:2px dashed var(--band)}
.ty,.lim{position:absolute;font-size:11px;line-height:1;white-space:nowrap;pointer-events:none}
.ty{right:100%;margin-right:6px;transform:translateY(-50%);color:var(--quiet)}
.lim{right:4px;padding:1px 3px;color:var(--limit);text-shadow:0 0 2px var(--card),0 0 3px var(--card)}
.lim.up{margin-top:2px}.lim.low{transform:translateY(-100%);margin-top:-2px}
.cursor{position:absolute;top:0;bottom:0;width:1px;background:var(--text);opacity:.6;pointer-events:none}
.pick{position:absolute;top:0;bottom:0;background:var(--band);opacity:.18;pointer-events:none}
.live{display:none}.scripted .live{display:revert}
.readout{position:sticky;top:0;z-index:2;margin:0;padding:6px 0;background:var(--page);font-size:14px;max-width:none;min-height:38px}
button{font:inherit;font-size:13px;padding:1px 10px;margin-left:10px;color:var(--text);background:var(--card);
border:1px solid var(--line);border-radius:4px;cursor:pointer}
.scroll{overflow-x:auto;margin:0 0 8px}
table{border-collapse:collapse;width:100%;font-size:14px}
th,td{padding:6px 14px 6px 0;text-align:right;vertical-align:baseline;border-bottom:1px solid var(--line);white-space:nowrap}
th{color:var(--quiet);font-size:13px;font-weight:500}
td:first-child,tr:first-child>th:first-child,th.text,td.text{text-align:left}th[colspan]{border:0;padding-bottom:0}
td.source{width:100%;max-width:0;min-width:110px;overflow:hidden;text-overflow:ellipsis;text-align:left}
td.over-limit{color:var(--bad);font-weight:650}
.gauge{display:inline-block;width:72px;height:6px;margin-left:8px;background:var(--grid);border-radius:2px;overflow:hidden}
.gauge i{display:block;height:100%;background:var(--band)}.over-limit .gauge i{background:var(--bad)}
.pair{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:8px 40px}
code,pre,td.source{font-family:ui-monospace,"Cascadia Code","SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace;font-size:13px}
pre{margin:6px 0 14px;padding:10px 14px;background:var(--card);border:1px solid var(--line);border-radius:6px;
white-space:pre-wrap;overflow-wrap:anywhere}
.diagnostics{margin:0;padding:0;list-style:none}
.diagnostics b.error{color:var(--bad)}.diagnostics .hint{color:var(--quiet)}
.facts{display:grid;grid-template-columns:max-content 1fr;gap:2px 20px;margin:0 0 14px;font-size:14px}
.facts dt{color:var(--quiet)}.facts dd{margin:0;overflow-wrap:anywhere}
@media(max-width:900px){.views,.pair{grid-template-columns:minmax(0,1fr)}}
@media(max-width:600px){main{padding:22px 14px 40px}h1{font-size:24px}.ticks text,.letter{font-size:19px}.card,.axis{padding:10px}
.figures{grid-template-columns:repeat(2,minmax(0,1fr));gap:16px}.figures dd{font-size:18px}.plot,.times{margin-left:50px}
.gauge{width:36px}th,td{padding-right:10px}}
@media print{main{max-width:none;padding:0}.live,.scripted .live,.readout{display:none}.card,.axis,.chart,table,pre,
.verdict{break-inside:avoid}h2,h3{break-after:avoid}body{font-size:12px}}
)";

std::string palette(std::string_view variables, Background background) {
  std::string out;
  put(out, ":root{", variables, "}", stroke_rules(background));
  for (std::size_t i = 0; i < speed_levels; ++i) {
    put(out, "i.v", std::to_string(i), "{background:", speed_color(i, background), "}");
  }
  return out;
}

}  // namespace

std::string page_style() {
  std::string out = palette(light, Background::light);
  put(out, "@media screen and (prefers-color-scheme:dark){", palette(dark, Background::dark), "}", rules);
  return out;
}

}  // namespace leadscrew::report
