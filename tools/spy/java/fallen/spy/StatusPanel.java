// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import fallen.service_status_t;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Name, state and figures of a service. */
class StatusPanel extends JPanel {
  private static final String[] STATES = {"starting", "running", "degraded", "lost", "stopping"};
  private static final Color GOOD = new Color(27, 138, 69);
  private static final Color BAD = new Color(207, 13, 54);

  private final JLabel title = new JLabel("waiting for a status");
  private final JLabel figures = new JLabel(" ");

  StatusPanel() {
    super(new BorderLayout(0, 8));
    setBorder(BorderFactory.createEmptyBorder(16, 20, 16, 20));
    title.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 20));
    figures.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
    add(title, BorderLayout.NORTH);
    add(figures, BorderLayout.CENTER);
    setPreferredSize(new java.awt.Dimension(460, 190));
  }

  /** @param status may be null: none has come yet. */
  void show(service_status_t status) {
    if (status == null) return;
    boolean isKnown = status.state >= 0 && status.state < STATES.length;
    title.setText(status.service + ": " + (isKnown ? STATES[status.state] : "state " + status.state));
    title.setForeground(status.state == service_status_t.RUNNING ? GOOD : BAD);
    figures.setText(String.format(
        "<html>%.1f results a second, %.1f ms each (99 %%: %.1f ms)<br>"
            + "received %d, published %d<br>late %d, damaged %d, lost on the way %d<br>%d MB, process %d<br>%s</html>",
        status.rate_hz, status.median_ms, status.p99_ms, status.received, status.published,
        status.dropped_late, status.dropped_damaged, status.lost_upstream,
        status.resident_bytes >> 20, status.pid, escaped(status.text)));
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;");
  }
}
