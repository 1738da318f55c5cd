// Boxes that scroll say so: where some of one lies below its edge, the class `more` draws a sign there.

export function tellsMore(box: HTMLElement): void {
  const look = () => box.classList.toggle('more', box.scrollHeight - box.scrollTop - box.clientHeight > 8);
  box.addEventListener('scroll', look, { passive: true });
  const sizes = new ResizeObserver(look);
  sizes.observe(box);
  for (const part of box.children) sizes.observe(part);
}
