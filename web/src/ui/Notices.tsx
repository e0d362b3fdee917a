import { useEffect } from "preact/hooks";
import type { Notice } from "../studio/studio";
import { useStore } from "../util/store";
import { Button } from "./controls";
import { useApp } from "./context";

/** How long a notice without findings stays, ms. */
const STAY = 6000;

/** Messages to the person at the page, in a corner. Errors and findings stay until they are closed. */
export function Notices() {
  const { studio } = useApp();
  const notices = useStore(studio.notices);
  const connection = useStore(studio.connection);
  return (
    <div class="notices" role="region" aria-label="Messages" aria-live="polite">
      {connection === "lost" && (
        <div class="notice error" data-testid="lost">
          <p>No connection to the server. The page connects again as soon as it runs.</p>
        </div>
      )}
      {notices.map((notice) => <NoticeBox key={notice.id} notice={notice} onClose={() => studio.dismiss(notice.id)} />)}
    </div>
  );
}

function NoticeBox({ notice, onClose }: { notice: Notice; onClose: () => void }) {
  const isBrief = notice.level === "note" && notice.findings.length === 0;
  useEffect(() => {
    if (!isBrief) return;
    const timer = setTimeout(onClose, STAY);
    return () => clearTimeout(timer);
  }, []);
  return (
    <div class={`notice ${notice.level}`} data-testid="notice">
      <div class="notice-head">
        <p>{notice.text}</p>
        <Button icon="close" label="Close" class="small" onClick={onClose} />
      </div>
      {notice.findings.length > 0 && (
        <ul class="findings">
          {notice.findings.map(({ level, place, message, remedy }, i) => (
            <li key={i} class={level}><strong>{place}</strong>: {message}{remedy && `; ${remedy}`}</li>
          ))}
        </ul>
      )}
    </div>
  );
}
