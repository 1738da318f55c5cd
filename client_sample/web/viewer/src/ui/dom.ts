// Elements of the page by id.

export function find<T extends Element = HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (element === null) throw new Error(`the page has no #${id}`);
  return element as unknown as T;
}

/** Writes only changes: repeating the same text sixty times a second costs nothing. Reuses the text node, which needs
 *  no style recalculation. */
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

/** The main element usually has the focus; that is shown only to users who navigate by Tab. */
export function showFocusToTabs(): void {
  addEventListener('keydown', ({ key }) => key === 'Tab' && document.body.classList.add('tabs'));
  addEventListener('pointerdown', () => document.body.classList.remove('tabs'));
}
