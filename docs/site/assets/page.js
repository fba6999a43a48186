// SPDX-License-Identifier: MIT
// What a page does: the search, the list of pages on a phone, light and dark. Works from file://, without a server.
(() => {
  const root = document.currentScript.dataset.root;
  const html = document.documentElement;

  const theme = document.getElementById("theme");
  theme.addEventListener("click", () => {
    const isDark = html.dataset.theme
      ? html.dataset.theme === "dark"
      : matchMedia("(prefers-color-scheme: dark)").matches;
    html.dataset.theme = isDark ? "light" : "dark";
    try {
      localStorage.setItem("talus-theme", html.dataset.theme);
    } catch {
      // A browser that keeps nothing for file:// forgets the choice with the page.
    }
  });

  const menu = document.getElementById("menu");
  menu.addEventListener("click", () => {
    const isOpen = document.body.classList.toggle("with-menu");
    menu.setAttribute("aria-expanded", String(isOpen));
  });

  const input = document.querySelector("#search input");
  const found = document.getElementById("found");
  let index = null;
  let chosen = -1;

  /** A script, because file:// allows no fetch. */
  function loadIndex() {
    if (index) return;
    index = new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = `${root}assets/search-records.js`;
      script.onerror = reject;
      script.onload = () => {
        const search = new MiniSearch({
          idField: "url",
          fields: ["title", "text", "page"],
          storeFields: ["url", "page", "title", "text"],
          searchOptions: {
            boost: { title: 4, page: 2 },
            prefix: true,
            fuzzy: (term) => (term.length > 4 ? 0.2 : 0),
            combineWith: "AND",
          },
        });
        search.addAll(window.talusRecords);
        resolve(search);
      };
      document.head.append(script);
    });
  }

  function cut(text, terms) {
    const lower = text.toLowerCase();
    const at = Math.max(
      0,
      Math.min(...terms.map((term) => lower.indexOf(term)).filter((i) => i >= 0), text.length) - 40,
    );
    return (at > 0 && at < text.length ? "…" : "") + text.slice(at < text.length ? at : 0).slice(0, 110);
  }

  async function show() {
    const query = input.value.trim();
    chosen = -1;
    if (!query) return hide();
    loadIndex();
    const results = (await index).search(query).slice(0, 12);
    if (input.value.trim() !== query) return;
    found.replaceChildren(
      ...results.map((result, i) => {
        const item = document.createElement("li");
        const link = document.createElement("a");
        link.href = root + result.url;
        link.id = `found-${i}`;
        const title = document.createElement("b");
        title.textContent = result.title === result.page ? result.title : `${result.title} · ${result.page}`;
        const text = document.createElement("span");
        text.textContent = cut(result.text, result.terms);
        link.append(title, text);
        item.append(link);
        return item;
      }),
    );
    if (!results.length) found.innerHTML = "<li><span>Nothing found.</span></li>";
    found.hidden = false;
    input.setAttribute("aria-expanded", "true");
  }

  function hide() {
    found.hidden = true;
    input.setAttribute("aria-expanded", "false");
  }

  input.addEventListener("focus", loadIndex);
  input.addEventListener("input", show);
  input.addEventListener("keydown", (event) => {
    const links = [...found.querySelectorAll("a")];
    if (event.key === "Escape") {
      hide();
      input.blur();
    } else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      if (!links.length) return;
      chosen = (chosen + (event.key === "ArrowDown" ? 1 : -1) + links.length) % links.length;
      links.forEach((link, i) => link.classList.toggle("chosen", i === chosen));
      input.setAttribute("aria-activedescendant", links[chosen].id);
      links[chosen].scrollIntoView({ block: "nearest" });
    } else if (event.key === "Enter" && links.length) location.href = links[Math.max(chosen, 0)].href;
  });
  document.addEventListener("click", (event) => event.target.closest("#search") || hide());
  found.addEventListener("click", hide);
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || /^(INPUT|TEXTAREA|SELECT)$/.test(document.activeElement.tagName)) return;
    event.preventDefault();
    input.focus();
  });
  addEventListener("beforeprint", () =>
    document.querySelectorAll("main details").forEach((part) => (part.open = true)),
  );
})();
