// Marks scrollable boxes with the class `more` while content lies below the edge.

export function tellsMore(box: HTMLElement): void {
  const update = () => box.classList.toggle('more', box.scrollHeight - box.scrollTop - box.clientHeight > 8);
  box.addEventListener('scroll', update, { passive: true });
  const sizes = new ResizeObserver(update);
  sizes.observe(box);
  for (const part of box.children) sizes.observe(part);
}
