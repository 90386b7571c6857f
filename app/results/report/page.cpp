#include "app/results/report/page.hpp"

namespace furrow::app {

const std::string_view page_style = R"css(
:root{--ink:#22302a;--faint:#6b7a72;--rule:#d9e0dc;--field:#2f6b4f}
*{box-sizing:border-box}
html{background:#eef1ee}
body{margin:0 auto;max-width:1150px;padding:0 0 48px;background:#fff;color:var(--ink);
 font:14px/1.45 system-ui,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif;
 font-variant-numeric:tabular-nums;-webkit-print-color-adjust:exact;print-color-adjust:exact}
header{display:flex;flex-wrap:wrap;align-items:baseline;gap:4px 18px;padding:22px 38px 18px;
 background:var(--field);color:#fff}
header h1{margin:0;font-size:25px;font-weight:650;letter-spacing:-.2px}
header p{margin:0;opacity:.88}
header .badge{margin-left:auto;padding:3px 12px;border-radius:20px;font-weight:600;background:#fff;
 color:var(--field)}
header .badge.bad{color:#b3261e}
section{padding:20px 38px 0}
h2{margin:12px 0 10px;padding-bottom:4px;font-size:17px;font-weight:650;
 border-bottom:2px solid var(--field)}
h3{margin:18px 0 6px;font-size:14px}
svg{display:block;max-width:100%;height:auto;font-family:inherit}
.cards{display:grid;grid-template-columns:repeat(4,1fr);gap:12px}
.card{padding:10px 14px;border:1px solid var(--rule);border-left:4px solid #9fb5a8;
 border-radius:5px;break-inside:avoid}
.card b{display:block;font-size:12px;font-weight:500;color:var(--faint)}
.card strong{display:block;font-size:23px;font-weight:650;line-height:1.25}
.card span{font-size:12px;color:var(--faint)}
.card.bad{border-left-color:#b3261e}.card.bad strong{color:#b3261e}
.card.good{border-left-color:#2f6b4f}
.maps{display:flex;flex-wrap:wrap;justify-content:space-evenly;gap:14px 20px}
.maps svg{break-inside:avoid}
.charts{display:grid;grid-template-columns:1fr 1fr;gap:14px;margin:10px 0;break-inside:avoid}
.legend{display:flex;flex-wrap:wrap;gap:3px 16px;margin:10px 0 2px;padding:0;list-style:none;
 font-size:12px;color:#444}
.legend .head{font-weight:600}
.legend li{display:flex;align-items:center}
.key{display:inline-block;width:14px;height:10px;margin-right:6px;border-radius:2px}
.key.ring{width:10px;background:#fff;border:2px solid var(--ink);border-radius:50%}
.key.diamond{width:8px;height:8px;border:1.5px solid var(--ink);border-radius:0;
 transform:rotate(45deg);margin-right:9px}
table{width:100%;border-collapse:collapse;margin:6px 0 4px;font-size:13px}
th{padding:4px 8px;text-align:right;font-weight:600;font-size:12px;color:var(--faint);
 border-bottom:1px solid #b9c4be;vertical-align:bottom}
td{padding:3.5px 8px;text-align:right;border-bottom:1px solid #edf0ee;vertical-align:top}
td{white-space:nowrap}
th.words,td.words{text-align:left;white-space:normal;overflow-wrap:break-word}
tr{break-inside:avoid}
tr.total td{font-weight:600;background:#f4f7f5}
tr.bad td{color:#b3261e}
table.narrow{width:auto;min-width:62%;break-inside:avoid}table.tight{font-size:12px}table.tight td,table.tight th{padding:2.5px 6px}
.two{display:grid;grid-template-columns:1fr 1fr;gap:0 34px;align-items:start}
.note{margin:4px 0 8px;font-size:12px;color:var(--faint)}
footer{padding:26px 38px 0;font-size:12px;color:var(--faint)}
@media screen and (max-width:760px){.cards{grid-template-columns:1fr 1fr}.two,.charts{grid-template-columns:1fr}
 section,header{padding-left:16px;padding-right:16px}table{display:block;overflow-x:auto}}
@page{size:A4;margin:12mm}
@media print{html{background:#fff}body{max-width:none;padding:0;font-size:11px}
 header{padding:10px 14px}section{padding:8px 0 0}h2,h3{break-after:avoid}
 .cards{gap:6px}.card{padding:5px 9px}.card strong{font-size:17px}.card span,.card b{font-size:10px}
 table,table.narrow{width:auto;min-width:62%;break-inside:avoid}table.tight{font-size:9.5px}th{font-size:9px}td,table.tight td{padding:1.5px 4px}
 .maps{gap:8px}.maps svg{max-height:158mm}.legend,.note{font-size:10px}footer{padding:10px 0 0}}
)css";

}  // namespace furrow::app
