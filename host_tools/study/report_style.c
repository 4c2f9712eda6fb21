#include "report_style.h"

#include <stddef.h>

/* Contrast against the background: text at least 7 : 1, muted text and marks at least 4.5 : 1. */
static const char light[] =
    ":root{color-scheme:light;--page:#fff;--box:#f5f7f9;--rule:#d5dae0;--ink:#15191e;"
    "--muted:#515b66;--grid:#e4e8ec;--path:#848e99;--blue:#1766ad;--orange:#b4540a;"
    "--green:#1a7048;--purple:#7044ab;--good:#176c43;--bad:#bb2525}\n";

static const char dark[] =
    "@media screen and (prefers-color-scheme:dark){"
    ":root{color-scheme:dark;--page:#12161b;--box:#1b2128;--rule:#38414b;--ink:#e9edf1;"
    "--muted:#a9b3be;--grid:#28303a;--path:#7d8894;--blue:#6cb4f5;--orange:#f39a52;"
    "--green:#63c890;--purple:#bf9ff2;--good:#63c890;--bad:#ff8078}}\n";

static const char *const rules[] = {
    "*{box-sizing:border-box}\n"
    "html{-webkit-text-size-adjust:100%;scroll-behavior:smooth}\n"
    "body{margin:0;background:var(--page);color:var(--ink);"
    "font:16px/1.55 system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif}\n"
    "main,header,footer{max-width:74rem;margin:0 auto;padding:0 1.25rem}\n"
    "header{padding-top:2.2rem}\nfooter{padding-bottom:3rem;color:var(--muted)}\n"
    "h1{font-size:clamp(1.5rem,1.1rem + 2vw,2.2rem);line-height:1.2;margin:0 0 .6rem;"
    "text-wrap:balance}\n"
    "h2{font-size:1.45rem;line-height:1.25;margin:3rem 0 .8rem;padding-top:1rem;"
    "border-top:2px solid var(--rule)}\n"
    "h3{font-size:1.05rem;line-height:1.35;margin:0 0 .8rem}\n"
    "h3 a{color:var(--muted);font-weight:500;text-decoration:none;margin-right:.35em}\n"
    "p{margin:.6rem 0;max-width:46rem}\na{color:var(--blue)}\n"
    ".lede{font-size:1.1rem}\n.muted{color:var(--muted)}\n"
    "a:focus-visible,.scroll:focus-visible{outline:3px solid var(--blue);outline-offset:2px}\n",
    "nav ol{list-style:none;display:flex;flex-wrap:wrap;gap:.4rem;padding:0;margin:1.4rem 0 "
    "0}\n"
    "nav a{display:block;padding:.3rem .7rem;border:1px solid var(--rule);border-radius:1rem;"
    "color:var(--ink);text-decoration:none;font-size:.92rem}\n"
    "nav a:hover{border-color:var(--blue)}\n"
    ".tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(10.5rem,1fr));gap:.8rem;"
    "margin:1.4rem 0;padding:0}\n"
    ".tiles div{background:var(--box);border:1px solid var(--rule);border-radius:.5rem;"
    "padding:.8rem 1rem}\n"
    ".tiles dd{margin:0;font-size:1.8rem;font-weight:650;line-height:1.2;"
    "font-variant-numeric:tabular-nums}\n"
    ".tiles dt{font-size:.9rem;color:var(--muted)}\n"
    ".tiles div{display:flex;flex-direction:column-reverse;justify-content:flex-end}\n",
    "figure{margin:1.6rem 0 2.2rem;padding:1.1rem;border:1px solid var(--rule);"
    "border-radius:.6rem;scroll-margin-top:1rem}\n"
    ".panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,25rem),1fr));"
    "gap:1rem 1.4rem;justify-items:center}\n"
    ".panel{width:100%;max-width:33rem;min-width:0}\n"
    ".panel svg{display:block;width:100%;height:auto;color:var(--ink);font-family:inherit}\n"
    ".panel .name{margin:0 0 .15rem;font-weight:600;font-size:.95rem;max-width:none}\n"
    ".legend{list-style:none;display:flex;flex-wrap:wrap;gap:.2rem 1.3rem;margin:.9rem 0 0;"
    "padding:0;font-size:.9rem}\n"
    ".legend li{display:flex;align-items:center;gap:.45rem}\n"
    ".legend svg{flex:none}\n"
    "figcaption{margin-top:.7rem;color:var(--muted);font-size:.9rem;max-width:58rem}\n",
    ".scroll{overflow-x:auto;margin:1.3rem 0;border:1px solid var(--rule);"
    "border-radius:.6rem}\n"
    "table{border-collapse:separate;border-spacing:0;width:100%;font-size:.88rem;line-height:1."
    "35}\n"
    "caption{text-align:left;padding:.7rem .8rem;font-size:.95rem}\n"
    "caption b{color:var(--muted);font-weight:500;margin-right:.35em}\n"
    "th,td{padding:.45rem .6rem;text-align:left;vertical-align:top;"
    "border-top:1px solid var(--rule)}\n"
    "thead th{background:var(--box);font-weight:600;vertical-align:bottom}\n"
    "tbody th{font-weight:600;white-space:nowrap;position:sticky;left:0;"
    "background:var(--page)}\n"
    "td.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}\n"
    "td.good,td.bad{white-space:nowrap;font-weight:600}td.n{font-weight:400}\n"
    ".good{color:var(--good)}\n.bad{color:var(--bad)}\n"
    "td.w{min-width:14rem}\n"
    "pre{background:var(--box);border:1px solid var(--rule);border-radius:.5rem;"
    "padding:.8rem 1rem;overflow-x:auto;font-size:.9rem;white-space:pre-wrap;"
    "overflow-wrap:anywhere}\n",
    "@media (max-width:34rem){main,header,footer{padding-left:.9rem;padding-right:.9rem}"
    "figure{padding:.7rem .6rem}.tiles dd{font-size:1.5rem}"
    ".tiles{grid-template-columns:1fr 1fr}caption{position:sticky;left:0;max-width:88vw}}\n",
    "@media print{@page{margin:14mm}html{font-size:10pt}body{font-size:10pt}nav{display:none}"
    "main,header,footer{max-width:none;padding:0}h2{margin-top:1.4rem;break-after:avoid}"
    "figure,.panel,.tiles "
    "div,tr{break-inside:avoid}#fig-spread{break-inside:auto}h3,caption,.panel "
    ".name{break-after:avoid}"
    "figure{padding:.5rem}.panels{grid-template-columns:1fr 1fr}.panel{max-width:8.2cm}"
    ".scroll{overflow:visible;border:0}table{font-size:7.6pt}th,td{padding:.2rem .35rem}"
    "tbody th{position:static}td.w{min-width:0}td.n{white-space:normal}"
    "a{color:inherit;text-decoration:none}}\n",
    "@media (prefers-reduced-motion:reduce){html{scroll-behavior:auto}}\n",
};

void report_style(FILE *page)
{
    fputs("<style>\n", page);
    fputs(light, page);
    fputs(dark, page);
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++) {
        fputs(rules[i], page);
    }
    fputs("</style>\n", page);
}
