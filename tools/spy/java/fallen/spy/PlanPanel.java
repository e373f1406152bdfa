// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import fallen.fallen_person_t;
import fallen.fallen_persons_t;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import javax.swing.JPanel;

/** The clusters of a decision from above: boxes to scale on a grid of metres, the camera in the middle below. */
class PlanPanel extends JPanel {
  private static final double REACH_M = 5;
  private static final int CAMERA_FRAME = 2;  // MapFrame: no vertical is known
  private static final Color PAPER = Color.WHITE;
  private static final Color INK = new Color(34, 34, 34);
  private static final Color GRID = new Color(222, 226, 231);
  private static final Color PERSON = new Color(214, 0, 56);
  private static final Color CANDIDATE = new Color(214, 140, 20);
  private static final Color CAMERA = new Color(11, 98, 196);

  private fallen_persons_t decision;

  PlanPanel() {
    setPreferredSize(new Dimension(720, 446));
    setBackground(PAPER);
  }

  /** @param shown may be null: none has come yet. */
  void show(fallen_persons_t shown) {
    decision = shown;
    repaint();
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    Graphics2D g = (Graphics2D) graphics;
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    paintGrid(g);
    g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 14));
    g.setColor(INK);
    g.drawString(describe(), 14, 24);
    if (decision == null || decision.frame == CAMERA_FRAME) return;
    for (fallen_person_t person : decision.hypotheses) paintPerson(g, person);
  }

  private String describe() {
    if (decision == null) return "waiting for a decision";
    if (decision.frame == CAMERA_FRAME) return "no floor in view: nothing to be drawn from above";
    int persons = 0;
    for (fallen_person_t person : decision.hypotheses) if (person.is_person) ++persons;
    return String.format("frame %d: %d fallen, %d clusters, threshold %.3f", decision.header.seq, persons,
        decision.count, decision.min_probability);
  }

  private double scale() {
    return Math.min(getWidth() / (2 * REACH_M), getHeight() / (REACH_M + 1.2));
  }

  /** Place on the panel of metres ahead and to the left of the camera. */
  private Point2D place(double ahead, double left) {
    return new Point2D.Double(getWidth() / 2.0 - left * scale(), getHeight() - 0.6 * scale() - ahead * scale());
  }

  /** Place on the panel of a point in the map, seen from the camera and along its view. */
  private Point2D placeOfMap(double x, double y) {
    double[] t = decision.T_map_camera;
    double length = Math.max(Math.hypot(t[2], t[6]), 1e-9);  // the view direction along the floor
    double forwardX = t[2] / length;
    double forwardY = t[6] / length;
    double dx = x - t[3];
    double dy = y - t[7];
    return place(dx * forwardX + dy * forwardY, dy * forwardX - dx * forwardY);
  }

  private void paintGrid(Graphics2D g) {
    g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 11));
    for (int metres = 0; metres <= REACH_M; ++metres) {
      g.setColor(GRID);
      g.draw(new Line2D.Double(place(metres, -REACH_M), place(metres, REACH_M)));
      g.draw(new Line2D.Double(place(0, metres), place(REACH_M, metres)));
      g.draw(new Line2D.Double(place(0, -metres), place(REACH_M, -metres)));
      g.setColor(INK);
      Point2D label = place(metres, -REACH_M);
      g.drawString(metres + " m", (float) label.getX() - 30, (float) label.getY() - 4);
    }
    Point2D camera = place(0, 0);
    g.setColor(CAMERA);
    g.fill(new Ellipse2D.Double(camera.getX() - 6, camera.getY() - 6, 12, 12));
  }

  private void paintPerson(Graphics2D g, fallen_person_t person) {
    double cos = Math.cos(person.box.yaw);
    double sin = Math.sin(person.box.yaw);
    Path2D outline = new Path2D.Double();
    double[][] signs = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < signs.length; ++i) {
      double x = signs[i][0] * person.box.size[0] / 2;
      double y = signs[i][1] * person.box.size[1] / 2;
      Point2D corner = placeOfMap(person.box.center[0] + cos * x - sin * y, person.box.center[1] + sin * x + cos * y);
      if (i == 0) outline.moveTo(corner.getX(), corner.getY());
      else outline.lineTo(corner.getX(), corner.getY());
    }
    outline.closePath();
    Color color = person.is_person ? PERSON : CANDIDATE;
    g.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), 50));
    g.fill(outline);
    g.setColor(color);
    g.setStroke(new BasicStroke(person.is_person ? 3 : 1.5f));
    g.draw(outline);
    g.setStroke(new BasicStroke(1));
    g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 13));
    Point2D label = placeOfMap(person.centroid[0], person.centroid[1]);
    g.drawString(String.format("p %.2f", person.probability), (float) label.getX() - 20, (float) label.getY() + 5);
  }
}
