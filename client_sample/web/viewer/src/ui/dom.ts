// Elements of the page by their id.

export function find<T extends Element = HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`the page has no #${id}`);
  return element as unknown as T;
}

/** Writes only what is different: a page that is told the same thing sixty times a second does no work. Into the text that
 *  is there, which asks for no new style. */
export function say(element: Element, text: string): void {
  const { firstChild } = element;
  if (!(firstChild instanceof Text) || firstChild.nextSibling !== null) {
    if (element.textContent !== text) element.textContent = text;
  } else if (firstChild.data !== text) {
    firstChild.data = text;
  }
}

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, text = ''): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  element.textContent = text;
  return element;
}

/** What fills the page has the focus mostly: that it has shows to those alone who walk through the page by Tab. */
export function showFocusToTabs(): void {
  addEventListener('keydown', ({ key }) => key === 'Tab' && document.body.classList.add('tabs'));
  addEventListener('pointerdown', () => document.body.classList.remove('tabs'));
}
