import { useEffect, useState } from "preact/hooks";

/** A value that reports its changes. */
export class Store<T> {
  private readonly listeners = new Set<() => void>();

  constructor(private value: T) {}

  get(): T {
    return this.value;
  }

  set(value: T): void {
    if (Object.is(value, this.value)) return;
    this.value = value;
    for (const listener of [...this.listeners]) listener();
  }

  update(change: (value: T) => T): void {
    this.set(change(this.value));
  }

  /** Calls `listener` after each change until the returned function is called. */
  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

/** Returns the value of a store and renders the component again when it changes. */
export function useStore<T>(store: Store<T>): T {
  const [value, setValue] = useState(() => store.get());
  useEffect(() => {
    const read = () => setValue(() => store.get());
    read();
    return store.subscribe(read);
  }, [store]);
  return value;
}

/** Returns a part of a store's value; the component is rendered again only when that part changes. */
export function useSelected<T, U>(store: Store<T>, select: (value: T) => U): U {
  const [, render] = useState(0);
  const selected = select(store.get());
  useEffect(() => {
    let last = selected;
    const compare = () => {
      const next = select(store.get());
      if (Object.is(next, last)) return;
      last = next;
      render((count) => count + 1);
    };
    compare();
    return store.subscribe(compare);
  });
  return selected;
}
