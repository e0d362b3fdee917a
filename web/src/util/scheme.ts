import { useEffect, useState } from "preact/hooks";

/** Returns whether the system is dark, and renders the component again when that changes. */
export function useDarkSystem(): boolean {
  const [media] = useState(() => matchMedia("(prefers-color-scheme: dark)"));
  const [isDark, setDark] = useState(media.matches);
  useEffect(() => {
    const read = () => setDark(media.matches);
    media.addEventListener("change", read);
    return () => media.removeEventListener("change", read);
  }, [media]);
  return isDark;
}
