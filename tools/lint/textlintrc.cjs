// SPDX-License-Identifier: MIT
// The words of the field for the pages: terms.json has [what is not written, what is written instead].
module.exports = { rules: { terminology: { defaultTerms: false, terms: require("./terms.json") } } };
