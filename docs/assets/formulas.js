// Formulas are set by Debian's MathJax 2 as vector graphics in the colour of the text; nothing comes from elsewhere.
window.MathJax = {
  jax: ["input/TeX", "output/SVG"],
  extensions: ["tex2jax.js"],
  TeX: {extensions: ["AMSmath.js", "AMSsymbols.js"]},
  tex2jax: {inlineMath: [["\\(", "\\)"]], displayMath: [["\\[", "\\]"]], processClass: "arithmatex", ignoreClass: "md-main"},
  SVG: {font: "TeX"},
  showMathMenu: false,
  messageStyle: "none",
};
